#include "experiment/new_effect.hpp"

#include <gtest/gtest.h>

#include "effect/catalogue.hpp"
#include "effect/effect.hpp"

namespace myo::experiment {
namespace {

const Box held_body{{0.0, 0.0, 0.0}, {0.1, 0.02, 0.03}};

/// A bar that is held at x = 0, under gravity along -z.
Experiment held_bar() {
    Experiment experiment;
    experiment.clamp_box_m = Box{{-0.001, -0.001, -0.001}, {0.001, 0.021, 0.031}};
    experiment.gravity_m_s2 = {0.0, 0.0, -9.81};
    experiment.trials.emplace_back();
    experiment.trials[0].name = "release";
    for (const char* name : {"tip", "side"}) experiment.markers.on_body.push_back({name, {0.1, 0.0, 0.0}, name});
    return experiment;
}

effect::EffectDeclaration new_on_bar(const std::string& id) {
    return new_effect(*effect::find_effect(id), held_bar(), {held_body, 0.5});
}

TEST(NewEffect, GivesEveryParameterAValueOfItsKindWithinItsRange) {
    for (const effect::Effect& entry : effect::effect_catalogue()) {
        const effect::EffectDeclaration added = new_on_bar(entry.id);
        ASSERT_EQ(added.parameters.size(), entry.parameters.size()) << entry.id;
        for (const effect::EffectParameterEntry& parameter : entry.parameters) {
            const effect::EffectParameter& value = added.parameters.at(parameter.name);
            if (const auto* number = std::get_if<double>(&value)) {
                EXPECT_GE(*number, parameter.lowest) << entry.id << " " << parameter.name;
                EXPECT_LE(*number, parameter.highest) << entry.id << " " << parameter.name;
            } else if (const auto* vector = std::get_if<Eigen::VectorXd>(&value)) {
                EXPECT_EQ(vector->size(), 3) << entry.id << " " << parameter.name;
                EXPECT_TRUE(vector->allFinite());
            }
        }
        if (entry.draw.amount.empty()) continue;
        const effect::EffectParameterEntry& amount = *entry.parameter(entry.draw.amount);
        EXPECT_GT(amount.kind == effect::EffectParameterKind::vector3
                      ? effect::vector(added.parameters, amount.name).norm()
                      : std::abs(effect::number(added.parameters, amount.name)),
                  0.0)
            << entry.id << " would do nothing";
    }
}

TEST(NewEffect, ActsAtTheFreeEndAndAgainstGravity) {
    EXPECT_TRUE(effect::vector(new_on_bar("point_mass").parameters, "position_m")
                    .isApprox(Eigen::Vector3d(0.1, 0.01, 0.015), 1e-12));
    EXPECT_TRUE(effect::vector(new_on_bar("end_stop").parameters, "normal").isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
    const Eigen::Vector3d axis = effect::vector(new_on_bar("gravity_tilt").parameters, "axis");
    EXPECT_NEAR(axis.z(), 0.0, 1e-12) << "an axis along gravity would tilt nothing";
    EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
    EXPECT_EQ(effect::number(new_on_bar("stiffness_gradient").parameters, "axis"), 0.0) << "along the bar";
    EXPECT_EQ(effect::number(new_on_bar("intrinsic_curvature").parameters, "axis"), 2.0) << "as gravity bends it";
    EXPECT_EQ(effect::number(new_on_bar("marker_slip").parameters, "time_s"), 0.5);
    EXPECT_EQ(effect::text(new_on_bar("marker_slip").parameters, "marker"), "tip");
}

TEST(NewEffect, SaysWhatIsLacking) {
    EXPECT_EQ(lacking_for(*effect::find_effect("linear_drag"), held_bar()), "");
    EXPECT_EQ(lacking_for(*effect::find_effect("tendon_friction"), held_bar()), "a tendon");
    EXPECT_EQ(lacking_for(*effect::find_effect("actuation_lag"), held_bar()), "a muscle, chamber or tendon");
    Experiment with = held_bar();
    with.muscles.emplace_back();
    with.muscles[0].name = "upper";
    EXPECT_EQ(lacking_for(*effect::find_effect("actuation_lag"), with), "");
    EXPECT_NE(lacking_for(*effect::find_effect("hung_mass"), with), "");
    with.trials[0].loads.emplace_back();
    EXPECT_EQ(lacking_for(*effect::find_effect("hung_mass"), with), "");
    with.markers.on_body.clear();
    const effect::EffectDeclaration nameless = new_effect(*effect::find_effect("marker_slip"), with, {held_body, 0.5});
    EXPECT_EQ(effect::text(nameless.parameters, "marker"), "marker") << "which the reader refuses";
}

}  // namespace
}  // namespace myo::experiment
