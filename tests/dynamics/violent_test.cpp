#include <gtest/gtest.h>

#include <random>

#include "dynamics/energy.hpp"
#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"

// The default scheme, a step of 10 ms, and loads nobody would put on a specimen: it stays stable, and nothing but the
// loads gives energy.

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double h = 0.01, gravity_m_s2 = 9.81;

struct Case {
    const char* element;
    double damping_s;
};

std::string label(const Case& c) { return std::string(c.element) + (c.damping_s > 0.0 ? "_damped" : ""); }

model::Model beam(const Case& c) {
    test::BeamSpec spec;
    spec.kind = test::element(c.element);
    spec.cells = spec.kind == fem::ElementKind::tet10 ? Eigen::Vector3i(4, 1, 1) : Eigen::Vector3i(7, 2, 2);
    spec.gravity_m_s2 = gravity_m_s2;
    spec.damping_s = c.damping_s;
    return test::make_beam(spec);
}

Matrix3Xd noise(Eigen::Index nodes, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, deviation);
    return Matrix3Xd::NullaryExpr(3, nodes, [&]() { return normal(random); });
}

Trace run_from(const model::Model& model, const InitialState& initial, double end_s) {
    SimulationOptions options;  // the defaults, but for the step
    options.h_s = h;
    options.end_s = end_s;
    options.initial = initial;
    return simulate(model, options);
}

/// How far the energy rises above what it was at `from_s`, in terms of all the energy there was to lose; and again from
/// the least on.
struct Rise {
    double above_start = 0.0, above_least = 0.0;
};
Rise energy_rise(const model::Model& model, const Trace& trace, double from_s) {
    const auto mass = model::mass_matrix(model);
    std::vector<double> total;
    for (std::size_t n = 0; n < trace.times_s.size(); ++n) {
        EXPECT_TRUE(trace.positions[n].allFinite() && trace.velocities[n].allFinite()) << n;
        if (trace.times_s[n] < from_s - 1e-9) continue;
        total.push_back(energy(model, mass, trace.positions[n], trace.velocities[n], trace.times_s[n]).total_J());
        EXPECT_TRUE(std::isfinite(total.back())) << n;
    }
    if (total.empty()) {
        ADD_FAILURE() << "no state from " << from_s << " s on";
        return {};
    }
    Rise rise;
    double least = total.front();
    for (const double now : total) {
        rise.above_start = std::max(rise.above_start, now - total.front());
        rise.above_least = std::max(rise.above_least, now - least);
        least = std::min(least, now);
    }
    const double scale = total.front() - least;
    return {rise.above_start / scale, rise.above_least / scale};
}

/// Distance of the end from a state of equilibrium near it, over the deflection under the body's own weight. A body
/// that was beaten into itself may come to rest in another equilibrium than the one it had.
double distance_from_rest(const model::Model& model, const Trace& trace) {
    StageSolver solver(model);
    const Matrix3Xd& X = model.body->mesh.nodes;
    Matrix3Xd hanging = X, near = trace.positions.back();
    for (Matrix3Xd* x : {&hanging, &near}) {
        const StageReport report = solve_equilibrium(solver, trace.times_s.back(), *x);
        EXPECT_TRUE(report.ok()) << report.message;
    }
    return (trace.positions.back() - near).cwiseAbs().maxCoeff() / (hanging - X).cwiseAbs().maxCoeff();
}

void expect_stable(const Case& c, const std::string& name, const model::Model& model, const Trace& trace,
                   double loads_constant_from_s) {
    const std::string what = name + "_" + label(c);
    EXPECT_TRUE(trace.complete()) << what << ": " << trace.message;
    const Rise rise = energy_rise(model, trace, loads_constant_from_s);
    test::record(what + "_energy_rise", {rise.above_start, rise.above_least});
    test::record(what + "_iterations_per_stage", static_cast<double>(trace.newton_iterations) / trace.stages);
    EXPECT_LT(rise.above_start, 0.05) << what;  // a step may gain a fiftieth of what moves
    if (c.damping_s == 0.0) return;
    EXPECT_LT(rise.above_least, 0.001) << what;
    const double distance = distance_from_rest(model, trace);
    test::record(what + "_distance_from_rest", distance);
    EXPECT_LT(distance, 0.02) << what;
}

class Violent : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(All, Violent,
                         testing::Values(Case{"hex8", 0.0}, Case{"tet10", 0.0}, Case{"hex8", 0.01},
                                         Case{"tet10", 0.01}),
                         [](const auto& test) { return label(test.param); });

/// Every node is thrown at 5 and at 20 body lengths per second, each its own way.
TEST_P(Violent, RandomInitialVelocities) {
    const Case c = GetParam();
    for (const double lengths_1_s : {5.0, 20.0}) {
        const model::Model model = beam(c);
        const Trace trace = run_from(model, {{}, noise(model.body->node_count(), 0.1 * lengths_1_s, 1)}, 1.0);
        expect_stable(c, "thrown_" + std::to_string(std::lround(lengths_1_s)), model, trace, 0.0);
    }
}

/// The free end swings sideways at 30 body lengths per second.
TEST_P(Violent, ABeatenBeam) {
    const Case c = GetParam();
    const model::Model model = beam(c);
    const Matrix3Xd& X = model.body->mesh.nodes;
    Matrix3Xd v = Matrix3Xd::Zero(3, X.cols());
    v.row(1) = 30.0 * X.row(0);
    v.row(2) = 10.0 * X.row(0);
    expect_stable(c, "beaten", model, run_from(model, {{}, v}, 1.0), 0.0);
}

/// Cells turned inside out by noise of the size of a cell.
TEST_P(Violent, ANoisyStart) {
    const Case c = GetParam();
    const model::Model model = beam(c);
    const Matrix3Xd& X = model.body->mesh.nodes;
    expect_stable(c, "noisy", model, run_from(model, {X + noise(X.cols(), 0.015, 2), {}}, 1.0), h);
}

/// The whole beam is its own mirror image, where the law has no energy.
TEST_P(Violent, AMirroredStart) {
    const Case c = GetParam();
    for (const int axis : {0, 1, 2}) {
        const model::Model model = beam(c);
        Matrix3Xd x = model.body->mesh.nodes;
        x.row(axis) = (axis == 0 ? 0.0 : 0.03) - x.row(axis).array();
        expect_stable(c, "mirrored_" + std::string(1, "xyz"[axis]), model, run_from(model, {x, {}}, 1.0), h);
    }
}

/// A hundred times its weight, downwards and sideways, until it is suddenly gone.
TEST_P(Violent, AHundredG) {
    const Case c = GetParam();
    for (const Vector3d& direction : {Vector3d(0.0, 0.0, -1.0), Vector3d(-1.0, 0.0, 0.0), Vector3d(1.0, 1.0, 1.0)}) {
        model::Model model = beam(c);
        const Eigen::VectorXd nodal = model::mass_matrix(model).isotropic *
                                      Eigen::VectorXd::Ones(model.body->node_count());
        model::DeadForce load;
        load.share = nodal / nodal.sum();
        load.force_N = 100.0 * gravity_m_s2 * nodal.sum() * direction.normalized();
        load.until_s = 0.255;  // within a step
        model.forces.push_back(load);
        expect_stable(c,
                      direction(1) > 0.0   ? "pulled"
                      : direction(0) < 0.0 ? "crushed"
                                           : "heavy",
                      model, run_from(model, {}, 1.2), load.until_s);
    }
}

}  // namespace
}  // namespace myo::dynamics
