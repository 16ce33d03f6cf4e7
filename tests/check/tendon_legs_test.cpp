#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "check/checks.hpp"
#include "support/chambered_beam.hpp"

namespace myo::check {
namespace {

/// Body bent to a circle about the y axis: sections stay plane and the axis at height z = 15 mm keeps its length.
Eigen::Matrix3Xd bent(const Eigen::Matrix3Xd& rest, double curvature_1_m) {
    Eigen::Matrix3Xd x = rest;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        const double angle = curvature_1_m * rest(0, i), radius_m = 1.0 / curvature_1_m - (rest(2, i) - 0.015);
        x(0, i) = radius_m * std::sin(angle);
        x(2, i) = 0.015 + 1.0 / curvature_1_m - radius_m * std::cos(angle);
    }
    return x;
}

/// What the check finds of a run that ends in these node positions.
std::vector<Finding> findings_at(const setup::Setup& setup, const std::vector<Eigen::Matrix3Xd>& states) {
    prediction::SetupRun run;
    run.values = prediction::declared_values(setup);
    run.predictions.resize(setup.trials.size());
    run.predictions[0].trace.positions = states;
    return check_tendon_legs({setup, &run});
}

TEST(CheckTendonLegs, SeesStraightLegsLeaveTheMaterialOfABentBody) {
    const test::Folder folder("tendon_legs");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons = {test::upper_tendon()};
    });
    const double leg_m = 0.035, lever_m = 0.013;  // of the last leg, the longest
    for (const double curvature_1_m : {8.0, 20.0}) {
        const Eigen::Matrix3Xd& rest = setup.mesh.mesh.nodes;
        const std::vector<Finding> findings = findings_at(setup, {rest, bent(rest, curvature_1_m)});
        ASSERT_EQ(findings.size(), 1u);
        const double sag_m = (1.0 / curvature_1_m - lever_m) * (1.0 - std::cos(0.5 * curvature_1_m * leg_m));
        // Cells of 15 mm follow the arc by chords.
        EXPECT_NEAR(findings[0].figure, sag_m / lever_m, 0.15 * sag_m / lever_m);
        EXPECT_EQ(findings[0].level, curvature_1_m > 10.0 ? CheckLevel::doubtful : CheckLevel::passed);
        if (curvature_1_m < 10.0) continue;
        EXPECT_THAT(findings[0].sentence, testing::HasSubstr("from guide 3 to 4, 35 mm, it runs straight"));
        EXPECT_THAT(findings[0].way_out, testing::HasSubstr("channel = true"));
    }
}

/// The points that hold a thread in a channel lie within cells: a bend that straight legs cut off is followed.
TEST(CheckTendonLegs, PassesAThreadInAChannel) {
    for (const bool bound : {true, false}) {
        const test::Folder folder("channel_legs");
        setup::Setup setup = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
            e.chambers.clear();
            e.tendons = {test::upper_tendon()};
            e.tendons[0].channel = bound;
        });
        // A channel whose points are as far apart as the guides is told in its own words.
        setup.experiment.tendons[0].channel = true;
        const std::vector<Finding> findings = findings_at(setup, {bent(setup.mesh.mesh.nodes, 20.0)});
        ASSERT_EQ(findings.size(), 1u);
        EXPECT_EQ(findings[0].level, bound ? CheckLevel::passed : CheckLevel::doubtful) << findings[0].figure;
        if (!bound) EXPECT_THAT(findings[0].way_out, testing::HasSubstr("finer mesh"));
    }
}

/// A declared effect that leads the threads through channels counts as one.
TEST(CheckTendonLegs, PassesAThreadThatAnEffectPutsInAChannel) {
    const test::Folder folder("affected_legs");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons = {test::upper_tendon()};
        e.effects = {{"tendon_channel", {{"share", 1.0}}}};
    });
    const std::vector<Finding> findings = findings_at(setup, {bent(setup.mesh.mesh.nodes, 20.0)});
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].level, CheckLevel::passed) << findings[0].figure;
}

}  // namespace
}  // namespace myo::check
