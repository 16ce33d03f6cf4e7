#include <gtest/gtest.h>

#include "dynamics/simulate.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/statics.hpp"
#include "support/tendon_body.hpp"

namespace myo::dynamics {
namespace {

/// A hanging cantilever of 20 x 2 x 2 cells, whose tendon bends it against its weight.
model::Model bent_body(double youngs_modulus_Pa, double tension_N) {
    test::BeamSpec spec;
    spec.size = {0.2, 0.01, 0.01};
    spec.cells = {20, 2, 2};
    spec.youngs_modulus_Pa = youngs_modulus_Pa;
    spec.poissons_ratio = 0.49;
    model::Model model = test::make_beam(spec);
    model.gravity_m_s2 = {9.81, 0.0, 0.0};
    std::vector<Eigen::Vector3d> path;
    for (int i = 0; i <= 10; ++i) path.emplace_back(0.02 * i, 0.005, 0.002);
    test::pull_by_tension(path, fibre::Signal::constant(tension_N), model);
    return model;
}

SimulationOptions hold(std::shared_ptr<const StagePath> similar = {}) {
    SimulationOptions options;
    options.start = StartKind::equilibrium;
    options.end_s = 0.0;
    options.keep_path = true;
    options.warm_start = std::move(similar);
    return options;
}

constexpr double soft_Pa = 3e5, strong_N = 1.0;

/// Counts of iterations, not times: the cost of a calibration of many holds.
TEST(Hold, TakesFewIterations) {
    const Trace cold = simulate(bent_body(soft_Pa, strong_N), hold());
    ASSERT_TRUE(cold.complete()) << cold.message;
    EXPECT_EQ(cold.times_s.size(), 1u);
    test::record("cold_iterations", cold.newton_iterations);
    EXPECT_LE(cold.newton_iterations, 40);
    // From the pose of an evaluation with a little another modulus, as in a fit.
    const Trace warm = simulate(bent_body(1.02 * soft_Pa, strong_N), hold(cold.path));
    ASSERT_TRUE(warm.complete()) << warm.message;
    test::record("warm_iterations", warm.newton_iterations);
    EXPECT_GE(warm.newton_iterations, 1);
    EXPECT_LE(warm.newton_iterations, 5);
    EXPECT_GT((warm.positions[0] - cold.positions[0]).cwiseAbs().maxCoeff(), 1e-4);
    // The way there does not matter.
    const Trace direct = simulate(bent_body(1.02 * soft_Pa, strong_N), hold());
    ASSERT_TRUE(direct.complete()) << direct.message;
    EXPECT_LT((warm.positions[0] - direct.positions[0]).cwiseAbs().maxCoeff(), 1e-6);
}

/// The pose is an equilibrium: that of the general solver, and it lies a quarter of its length off its axis.
TEST(Hold, IsTheEquilibrium) {
    const model::Model model = bent_body(soft_Pa, strong_N);
    const Trace held = simulate(model, hold());
    ASSERT_TRUE(held.complete()) << held.message;
    EXPECT_LT((held.positions[0] - test::equilibrium(model)).cwiseAbs().maxCoeff(), 1e-6);
    double highest = 0.0;
    for (const auto& node : held.positions[0].colwise()) highest = std::max(highest, std::abs(node.z()));
    EXPECT_GT(highest, 0.05);
}

/// Where a body gives way, the message names the command next to the last pose.
TEST(Hold, SaysWhereTheBodyGivesWay) {
    const Trace held = simulate(bent_body(soft_Pa, 100.0 * strong_N), hold());
    EXPECT_EQ(held.status, RunStatus::failed);
    EXPECT_NE(held.message.find("gives way"), std::string::npos) << held.message;
    EXPECT_NE(held.message.find("less than the 100 N"), std::string::npos) << held.message;
}

}  // namespace
}  // namespace myo::dynamics
