#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "mesh/surface_mesh.hpp"
#include "prediction/parameter_tangent.hpp"
#include "prediction/prediction.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

// Effects of robots with tendons and of markers that are glued on by hand.

namespace myo::prediction {
namespace {

using experiment::Experiment;

effect::EffectDeclaration declared(const std::string& id, effect::EffectParameters parameters) {
    effect::EffectDeclaration effect;
    effect.id = id;
    effect.parameters = std::move(parameters);
    return effect;
}

setup::Setup beam(const test::Folder& folder, const std::vector<effect::EffectDeclaration>& effects,
                  const Eigen::Vector3d& shift_m = Eigen::Vector3d::Zero()) {
    return test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.chambers.clear();
        e.effects = effects;
        for (experiment::MarkerDeclaration& marker : e.markers.on_body)
            if (marker.name == "middle") marker.rest_m += shift_m;
    });
}

/// A marker that the effect moves is one that is declared at that place.
TEST(MarkerOffset, MovesTheMarkerOnTheBody) {
    const test::Folder folder("marker_offset");
    const Eigen::Vector3d shift(0.012, -0.004, 0.0);
    const setup::Setup moved = beam(
        folder, {declared("marker_offset", {{"marker", std::string("middle")}, {"shift_m", Eigen::VectorXd(shift)}})});
    const setup::Setup there = beam(folder, {}, shift);
    const TrialPrediction by_effect = predict_trial(moved, 0, declared_values(moved));
    const TrialPrediction by_place = predict_trial(there, 0, declared_values(there));
    ASSERT_TRUE(by_effect.ok() && by_place.ok());
    const std::size_t middle = 3;
    EXPECT_LT((by_effect.positions_m[middle] - by_place.positions_m[middle]).norm(), 1e-9);
    EXPECT_GT((by_effect.positions_m[middle] - by_place.positions_m[0]).norm(), 1e-3);
    // The others stay where they are.
    EXPECT_LT((by_effect.positions_m[0] - by_place.positions_m[0]).norm(), 1e-9);
}

setup::Setup tendon_beam(const test::Folder& folder, double friction,
                         const std::vector<effect::EffectDeclaration>& effects,
                         const std::function<void(Experiment&)>& change = {}) {
    return test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.chambers.clear();
        e.effects = effects;
        experiment::TendonDeclaration tendon = test::upper_tendon({0.028, 0.014, 0.028, 0.014});
        tendon.friction = friction;
        e.tendons = {tendon};
        e.trials[0].hold = true;
        e.trials[0].start = experiment::StartState::equilibrium;
        e.trials[0].constant_commands = {{"upper", 4.0}};
        if (change) change(e);
    });
}

/// The effect adds to the declared friction, at all tendons or at the named one.
TEST(TendonFriction, AddsToWhatIsDeclared) {
    const test::Folder folder("tendon_friction");
    const auto tip = [&](const setup::Setup& setup) {
        const TrialPrediction prediction = predict_trial(setup, 0, declared_values(setup));
        EXPECT_TRUE(prediction.ok()) << prediction.message;
        return Eigen::Vector3d(prediction.positions_m[0].col(0));
    };
    const Eigen::Vector3d declared_tip = tip(tendon_beam(folder, 0.3, {}));
    const Eigen::Vector3d added = tip(tendon_beam(folder, 0.1, {declared("tendon_friction", {{"coefficient", 0.2}})}));
    const Eigen::Vector3d named = tip(tendon_beam(
        folder, 0.1, {declared("tendon_friction", {{"coefficient", 0.2}, {"tendon", std::string("upper")}})}));
    EXPECT_LT((added - declared_tip).norm(), 1e-9);
    EXPECT_LT((named - declared_tip).norm(), 1e-9);
    EXPECT_GT((tip(tendon_beam(folder, 0.1, {})) - declared_tip).norm(), 1e-5) << "it matters";
}

/// A whole share is a declared channel; none leaves the declared thread; in between the pose is in between.
TEST(TendonChannel, IsTheDeclaredChannelAtAWholeShare) {
    const test::Folder folder("tendon_channel");
    const auto tip = [&](const std::optional<double>& share, bool channel) {
        std::vector<effect::EffectDeclaration> effects;
        if (share) effects.push_back(declared("tendon_channel", {{"share", *share}}));
        const setup::Setup setup = tendon_beam(folder, 0.0, effects, [&](Experiment& e) {
            e.tendons[0].path_m = Eigen::Matrix3Xd(e.tendons[0].path_m(Eigen::all, {0, 3}));  // one leg
            e.tendons[0].channel = channel;
        });
        const TrialPrediction prediction = predict_trial(setup, 0, declared_values(setup));
        EXPECT_TRUE(prediction.ok()) << prediction.message;
        return Eigen::Vector3d(prediction.positions_m[0].col(0));
    };
    const Eigen::Vector3d straight = tip({}, false), channel = tip({}, true);
    const double apart = (straight - channel).norm();
    EXPECT_GT(apart, 1e-4) << "it matters";
    EXPECT_LT((tip(0.0, false) - straight).norm(), 1e-9);
    EXPECT_LT((tip(1.0, false) - channel).norm(), 0.02 * apart);
    const double half = (tip(0.5, false) - straight).norm();
    EXPECT_GT(half, 0.3 * apart);
    EXPECT_LT(half, 0.7 * apart);
}

/// Beyond the body the nearest point of its surface stays where it is, so that a fit would wander there.
TEST(PlacesOfEffects, AreBoundedByTheBody) {
    const test::Folder folder("bounded_places");
    for (const double x : {0.05, 0.25}) {
        const effect::EffectDeclaration friction = declared(
            "dry_friction",
            {{"friction_force_N", 0.01}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(x, 0.01, -0.02))}});
        const setup::Setup setup = beam(folder, {friction});
        const Box body = mesh::bounding_box(setup.surface.vertices);
        int places = 0;
        for (const ModelParameter& p : effect_parameters(setup, friction, 0)) {
            if (p.of_effect != "position_m") continue;
            ++places;
            EXPECT_LE(p.parameter.lower, p.parameter.value);
            EXPECT_GE(p.parameter.upper, p.parameter.value);
            EXPECT_EQ(p.parameter.lower, std::min(body.lowest(p.component), p.parameter.value));
            EXPECT_EQ(p.parameter.upper, std::max(body.highest(p.component), p.parameter.value));
        }
        EXPECT_EQ(places, 3);
    }
}

}  // namespace
}  // namespace myo::prediction
