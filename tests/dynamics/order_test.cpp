#include <gtest/gtest.h>

#include <algorithm>

#include "dynamics/simulate.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

test::BeamSpec soft() {
    test::BeamSpec spec;
    spec.cells = {4, 1, 1};
    spec.gravity_m_s2 = 9.81;
    return spec;
}

Trace run(const Model& model, Integrator integrator, double h, double end) {
    SimulationOptions options;
    options.integrator = integrator;
    options.h_s = h;
    options.end_s = end;
    options.solver.tolerance = 1e-9;
    Trace trace = simulate(model, options);
    EXPECT_TRUE(trace.complete()) << trace.message;
    return trace;
}

/// Error of the final positions against a much finer TR-BDF2 run, relative to the motion, and its orders.
std::vector<double> orders(const Model& model, Integrator integrator, const std::vector<double>& h, double end, const std::string& name) {
    const Matrix3Xd reference = run(model, Integrator::tr_bdf2, h.back() / 8.0, end).positions.back();
    const double motion = (reference - model.body->mesh.nodes).norm();
    std::vector<double> errors;
    for (const double step : h) errors.push_back((run(model, integrator, step, end).positions.back() - reference).norm() / motion);
    const std::vector<double> found = test::observed_orders(h, errors);
    test::record(name + "_errors", errors);
    test::record(name + "_orders", found);
    return found;
}

TEST(OrderInTime, TrBdf2IsOfSecondAndImplicitEulerOfFirstOrder) {
    struct Run {
        const char* name;
        double damping_s, velocity_force;
    };
    for (const Run& r : {Run{"damped", 0.003, 0.0}, Run{"velocity_force", 0.003, 4.0}, Run{"negative_velocity_force", 0.001, -4.0}}) {
        test::BeamSpec spec = soft();
        spec.damping_s = r.damping_s;
        Model model = test::make_beam(spec);
        model.velocity_force_1_s = r.velocity_force;
        const std::vector<double> second =
            orders(model, Integrator::tr_bdf2, {0.01, 0.005, 0.0025}, 0.16, std::string("tr_bdf2_") + r.name);
        EXPECT_GT(second.back(), 1.8) << r.name;
        const std::vector<double> first =
            orders(model, Integrator::implicit_euler, {0.005, 0.0025, 0.00125}, 0.16, std::string("implicit_euler_") + r.name);
        EXPECT_GT(first.back(), 0.75) << r.name;
        EXPECT_LT(first.back(), 1.3) << r.name;
    }
}

TEST(OrderInTime, WithoutDampingTheOrderIsTheSame) {
    const Model model = test::make_beam(soft());
    EXPECT_GT(orders(model, Integrator::tr_bdf2, {0.005, 0.0025, 0.00125}, 0.1, "tr_bdf2_undamped").back(), 1.8);
}

/// A force that comes and goes inside steps, with a velocity force: its jumps end steps, so the order stays.
TEST(Jumps, LoadsThatJumpInsideAStepKeepTheOrder) {
    test::BeamSpec spec = soft();
    spec.damping_s = 0.004;
    Model model = test::make_beam(spec);
    model.velocity_force_1_s = -30.0;
    test::push_tip(model, spec, {0.0, 0.0, 0.6});
    model.forces.back().from_s = 0.0313;
    model.forces.back().until_s = 0.0777;
    EXPECT_GT(orders(model, Integrator::tr_bdf2, {0.005, 0.0025, 0.00125}, 0.11, "tr_bdf2").back(), 1.8);
    const double first = orders(model, Integrator::implicit_euler, {0.005, 0.0025, 0.00125}, 0.11, "implicit_euler").back();
    EXPECT_GT(first, 0.75);
    const Trace trace = run(model, Integrator::tr_bdf2, 0.01, 0.11);
    EXPECT_EQ(std::count(trace.times_s.begin(), trace.times_s.end(), 0.0313), 1);
    EXPECT_EQ(std::count(trace.times_s.begin(), trace.times_s.end(), 0.0777), 1);
    EXPECT_EQ(trace.times_s.size(), 14u);   // start, eleven steps, two jumps
}

TEST(Jumps, ActivationStepsKeepTheOrder) {
    test::BeamSpec spec = soft();
    spec.damping_s = 0.004;
    Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<FibreGroup>>();
    fibres->push_back(fibres_in_box(model.body->mesh, Box{{0, 0, 0.02}, {0.1, 0.03, 0.03}}, Eigen::Vector3d::UnitX(), 1e5, "top"));
    model.fibres = fibres;
    model.activation = {Signal::step(0.0237, 1.0, 0.8)};
    EXPECT_GT(orders(model, Integrator::tr_bdf2, {0.005, 0.0025, 0.00125}, 0.08, "tr_bdf2").back(), 1.8);
}

/// A jump within rounding of the end of a step, on either side, or of the start, is the jump there.
TEST(Jumps, WithinRoundingOfAStepEndAreThatStepEnd) {
    test::BeamSpec spec = soft();
    Model model = test::make_beam(spec);
    test::push_tip(model, spec, {0.0, 0.0, 0.6});
    for (const double time : {0.0, 0.03}) {
        model.forces.back().from_s = time;
        const Trace aligned = run(model, Integrator::tr_bdf2, 0.01, 0.06);
        for (const double shift : {-1e-12, -4e-18, 4e-18, 1e-12}) {
            if (time == 0.0 && shift < 0.0) continue;
            model.forces.back().from_s = time + shift;
            const Trace shifted = run(model, Integrator::tr_bdf2, 0.01, 0.06);
            EXPECT_EQ(shifted.times_s.size(), aligned.times_s.size()) << shift;
            const double motion = (aligned.positions.back() - model.body->mesh.nodes).norm();
            EXPECT_LT((shifted.positions.back() - aligned.positions.back()).norm(), 1e-8 * motion) << time << " " << shift;
        }
    }
}

/// A jump close to a step end takes its place: no step is so short that rounding would show in its accelerations.
TEST(Jumps, BesideAStepEndLeaveNoTinyStep) {
    test::BeamSpec spec = soft();
    Model model = test::make_beam(spec);
    test::push_tip(model, spec, {0.0, 0.0, 0.6});
    model.forces.back().from_s = 0.03 - 1e-6;
    model.forces.back().until_s = 0.05 + 1e-7;
    const Trace trace = run(model, Integrator::tr_bdf2, 0.01, 0.08);
    for (std::size_t n = 1; n < trace.times_s.size(); ++n) EXPECT_GT(trace.times_s[n] - trace.times_s[n - 1], 0.0099);
    EXPECT_DOUBLE_EQ(trace.times_s.back(), 0.08);
    model.forces.back().from_s = 0.03;
    model.forces.back().until_s = 0.05;
    const Trace aligned = run(model, Integrator::tr_bdf2, 0.01, 0.08);
    const double motion = (aligned.positions.back() - model.body->mesh.nodes).norm();
    EXPECT_LT((trace.positions.back() - aligned.positions.back()).norm(), 1e-3 * motion);
}

}  // namespace
}  // namespace myo
