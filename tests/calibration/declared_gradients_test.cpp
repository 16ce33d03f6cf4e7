#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/gradcheck.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

namespace myo::calibration {
namespace {

/// Rows of numbers of effects and of a part: tangents of the run against differences.
TEST(DeclaredGradients, AgreeWithDifferences) {
    const test::Folder folder("declared_gradients");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        experiment::PartDeclaration part;
        part.name = "tip";
        part.place = Box{{0.06, -0.01, -0.01}, {0.11, 0.04, 0.04}};
        part.youngs_modulus_Pa = 6e5;
        part.poissons_ratio = 0.49;
        part.density_kg_m3 = 1070.0;
        part.damping_s = 0.002;
        e.parts.push_back(part);
        e.trials[0].actuation_steps = {{"upper", 5000.0}};
        const Eigen::VectorXd centre = Eigen::Vector3d(0.03, 0.015, 0.004);
        e.effects = {{"soft_patch", {{"relative_change", -0.3}, {"centre_m", centre}, {"radius_m", 0.01}}},
                     {"actuation_lag", {{"time_constant_s", 0.02}}},
                     {"scale_error", {{"relative_error", 0.01}}}};
    });
    const TrialGradientCheck run = gradcheck(setup, 0, 3);
    ASSERT_TRUE(run.check.complete()) << run.check.message;
    std::vector<double> errors;
    std::vector<std::string> names;
    for (const sensitivity::GradientCheckRow& row : run.check.rows) {
        if (row.name.rfind("effect.", 0) != 0 && row.name.rfind("tip.", 0) != 0) continue;
        names.push_back(row.name);
        errors.push_back(row.relative_error);
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        EXPECT_NE(row.adjoint, row.difference) << row.name << ": not independent";
        EXPECT_LE(row.relative_error, 1e-5) << row.name;
    }
    EXPECT_THAT(names, testing::ElementsAre("tip.youngs_modulus_Pa", "tip.damping_s",
                                            "effect.soft_patch.relative_change", "effect.soft_patch.centre_m.x",
                                            "effect.soft_patch.centre_m.y", "effect.soft_patch.centre_m.z",
                                            "effect.soft_patch.radius_m", "effect.actuation_lag.time_constant_s"));
    test::record("relative_errors", errors);
    EXPECT_LE(run.check.median_error(), 1e-6);
    ASSERT_EQ(run.left_out.size(), 1u);
    EXPECT_THAT(run.left_out[0], testing::StartsWith("effect.scale_error.relative_error"));
}

/// A tension of 0 has no difference on both sides; the check pulls the tendon taut.
TEST(TendonGradient, AgreesWithDifferencesWhereNothingPulls) {
    const test::Folder folder("slack_gradient");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons.push_back(test::upper_tendon());
    });
    const TrialGradientCheck run = gradcheck(setup, 0, 2);
    ASSERT_TRUE(run.check.complete()) << run.check.message;
    int tensions = 0;
    for (const sensitivity::GradientCheckRow& row : run.check.rows)
        if (row.name.find("tension_N") != std::string::npos) {
            ++tensions;
            EXPECT_NE(row.adjoint, 0.0);
            EXPECT_LE(row.relative_error, 5e-5) << row.name;
        }
    EXPECT_EQ(tensions, 1);
}

}  // namespace
}  // namespace myo::calibration
