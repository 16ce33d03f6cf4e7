#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/softening.hpp"
#include "dynamics/statics.hpp"
#include "support/figures.hpp"
#include "support/pulled_block.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

/// Isochoric energy density of a small strain under a stress along one axis.
double isochoric(const test::BeamSpec& spec, double strain) {
    const double mu = 0.5 * spec.youngs_modulus_Pa / (1.0 + spec.poissons_ratio),
                 shear = (1.0 + spec.poissons_ratio) * strain;
    return 2.0 / 3.0 * mu * shear * shear;
}

/// Pulled to 100, 200, 100, 200, 100 Pa: after the largest load the block answers in proportion, unloading and loading
/// alike, with the factor of the largest strain it has had; before, less softly.
TEST(Softening, TheSecondLoadingFollowsTheUnloading) {
    const test::BeamSpec spec = test::light_cube();
    model::Model model = test::make_beam(spec);
    const double strain = 200.0 / spec.youngs_modulus_Pa;
    model.softening = material::StressSoftening{0.4, isochoric(spec, strain)};
    const double stresses[] = {100.0, 200.0, 100.0, 200.0, 100.0};
    for (int k = 0; k < 5; ++k) test::pull(model, spec, stresses[k], 0.2 * k, 0.2 * (k + 1));
    const Trace trace = simulate(model, test::short_steps(StartKind::straight, 0.01, 1.0));
    ASSERT_TRUE(trace.complete()) << trace.message;
    double largest = 0.0, at_end[5] = {};
    for (std::size_t n = 0; n < trace.times_s.size(); ++n) {
        const double now = test::stretch_of(model, spec, trace.positions[n]);
        largest = std::max(largest, now);
        at_end[static_cast<int>(trace.times_s[n] / 0.2 - 1e-6)] = now;  // a load acts up to and at its end
    }
    const double factor = model.softening->factor(isochoric(spec, largest));
    test::record("factor", factor);
    EXPECT_LT(factor, 0.75);
    for (int k = 1; k < 5; ++k)
        EXPECT_NEAR(at_end[k] * factor * spec.youngs_modulus_Pa / stresses[k], 1.0, 0.01)
            << k;  // strains of 3e-3 are not small to the square
    EXPECT_NEAR(at_end[1], at_end[3], 1e-4 * at_end[1]);
    EXPECT_NEAR(at_end[2], at_end[4], 1e-4 * at_end[2]);
    EXPECT_LT(at_end[0], 0.97 * at_end[2]);
}

model::Model soft_beam() {
    test::BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.003;
    model::Model model = test::make_beam(spec);
    model.softening = material::StressSoftening{0.5, 200.0};
    return model;
}

TEST(Softening, WithoutDamageChangesNothing) {
    model::Model model = soft_beam();
    const SimulationOptions options = test::short_steps(StartKind::straight, 0.005, 0.2);
    const Trace softened = simulate(model, options);
    model.softening->damage_max = 0.0;
    const Trace undamaged = simulate(model, options);
    model.softening.reset();
    const Trace plain = simulate(model, options);
    ASSERT_TRUE(softened.complete() && undamaged.complete() && plain.complete());
    EXPECT_EQ(undamaged.positions.back(), plain.positions.back());
    EXPECT_GT((softened.positions.back() - plain.positions.back()).norm(),
              0.02 * (plain.positions.back() - plain.positions.front()).norm());
}

/// Also on a solver that has softened its cells before.
TEST(Softening, EveryRunStartsVirgin) {
    const model::Model model = soft_beam();
    const SimulationOptions options = test::short_steps(StartKind::straight, 0.005, 0.1);
    StageSolver solver(model, options.solver);
    const Trace first = simulate_part(solver, options, {}), second = simulate_part(solver, options, {});
    ASSERT_TRUE(first.complete() && second.complete());
    const double motion = (first.positions.back() - first.positions.front()).norm();
    ASSERT_EQ(first.positions.size(), second.positions.size());
    for (std::size_t n = 0; n < first.positions.size(); ++n)
        EXPECT_LT((first.positions[n] - second.positions[n]).norm(), 1e-6 * motion);
}

/// A point of a run remembers its softening.
TEST(Softening, ARunCanBeTakenUpAgain) {
    const model::Model model = soft_beam();
    const SimulationOptions options = test::short_steps(StartKind::straight, 0.005, 0.1);
    RunPoint middle;
    RunObserver observer;
    observer.reached = [&](const RunPoint& point) {
        if (point.step == 10) middle = point;
    };
    const Trace whole = simulate(model, options, {}, observer);
    StageSolver solver(model, options.solver);
    const Trace rest = simulate_part(solver, options, {&middle});
    ASSERT_TRUE(whole.complete() && rest.complete());
    EXPECT_LT((whole.positions.back() - rest.positions.back()).norm(),
              1e-6 * (whole.positions.back() - whole.positions.front()).norm());
}

TEST(Softening, ABodyAtItsEquilibriumStaysAtRest) {
    model::Model model = soft_beam();
    const Trace trace = simulate(model, test::short_steps(StartKind::equilibrium, 0.005, 0.1));
    ASSERT_TRUE(trace.complete()) << trace.message;
    const double sag = (trace.positions.front() - model.body->mesh.nodes).norm();
    for (const Matrix3Xd& x : trace.positions) EXPECT_LT((x - trace.positions.front()).norm(), 1e-4 * sag);
    model.softening.reset();
    StageSolver solver(model);
    Matrix3Xd x = model.body->mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    EXPECT_GT(sag, 1.02 * (x - model.body->mesh.nodes).norm());
}

/// What a point is softened by never heals, and its peak is the largest energy of the motion.
TEST(Softening, PeaksOnlyRise) {
    const model::Model model = soft_beam();
    Eigen::VectorXd last = Eigen::VectorXd::Zero(model.body->point_count()), seen;
    RunObserver observer;
    observer.reached = [&](const RunPoint& point) {
        EXPECT_TRUE((point.peak_energy_J_m3.array() >= last.array()).all());
        last = point.peak_energy_J_m3;
        raise_peaks(model, point.state.x, seen);
        EXPECT_LT((seen - last).cwiseAbs().maxCoeff(), 1e-12 * (1.0 + last.maxCoeff()));
    };
    ASSERT_TRUE(simulate(model, test::short_steps(StartKind::straight, 0.005, 0.3), {}, observer).complete());
    EXPECT_GT(last.maxCoeff(), 10.0);
}

}  // namespace
}  // namespace myo::dynamics
