#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/simulate.hpp"
#include "model/directional_mass.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using test::run;

test::BeamSpec coarse_beam() {
    test::BeamSpec spec;
    spec.cells = {4, 1, 1};
    spec.gravity_m_s2 = 9.81;
    return spec;
}

/// Fibres along the upper third.
void add_muscle(model::Model& model, const fibre::Signal& activation) {
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0, 0, 0.02}, {0.1, 0.03, 0.03}},
                                           Eigen::Vector3d::UnitX(), 1e5, "top"));
    model.fibres = fibres;
    model.activation = {activation};
}

/// Error of the final positions against a much finer TR-BDF2 run, relative to the motion, and its orders.
std::vector<double> orders(const model::Model& model, const TimeScheme& scheme, const std::vector<double>& h,
                           double end, const std::string& name) {
    const Matrix3Xd reference = run(model, Integrator::tr_bdf2, h.back() / 8.0, end).positions.back();
    const double motion = (reference - model.body->mesh.nodes).norm();
    std::vector<double> errors;
    for (const double step : h)
        errors.push_back((run(model, scheme, step, end).positions.back() - reference).norm() / motion);
    const std::vector<double> found = test::observed_orders(h, errors);
    test::record(name + "_errors", errors);
    test::record(name + "_orders", found);
    return found;
}

/// Implicit Euler is of first order, all others of second, with strain-rate damping and velocity forces of either sign.
TEST(OrderInTime, IsThatOfTheScheme) {
    struct Run {
        const char* name;
        double damping_s, velocity_force;
    };
    for (const Run& r :
         {Run{"damped", 0.003, 0.0}, Run{"velocity_force", 0.003, 4.0}, Run{"negative_velocity_force", 0.001, -4.0}}) {
        test::BeamSpec spec = coarse_beam();
        spec.damping_s = r.damping_s;
        model::Model model = test::make_beam(spec);
        model.velocity_force_1_s = r.velocity_force;
        for (const auto& [name, scheme] : test::all_schemes()) {
            const std::string label = std::string(name) + "_" + r.name;
            if (scheme.integrator == Integrator::implicit_euler) {
                const std::vector<double> first = orders(model, scheme, {0.005, 0.0025, 0.00125}, 0.16, label);
                EXPECT_GT(first.back(), 0.75) << label;
                EXPECT_LT(first.back(), 1.3) << label;
            } else {
                EXPECT_GT(orders(model, scheme, {0.005, 0.0025, 0.00125}, 0.16, label).back(), 1.8) << label;
            }
        }
    }
}

/// Without damping, of the first mode's coordinate: nothing takes away the modes too fast for these steps that a
/// release excites.
TEST(OrderInTime, WithoutDampingTheOrderIsTheSame) {
    const model::Model model = test::held(test::ringing_beam());
    const NaturalMode mode = test::first_mode(model);
    const double end = 0.06;
    const auto coordinate = [&](const TimeScheme& scheme, double h) {
        const Eigen::VectorXd q = test::ring(model, mode, scheme, h, static_cast<int>(std::lround(end / h)));
        return q.size() > 0 ? q(q.size() - 1) / q.cwiseAbs().maxCoeff() : std::numeric_limits<double>::quiet_NaN();
    };
    const std::vector<double> h{0.005, 0.0025, 0.00125};
    const double exact = coordinate(Integrator::tr_bdf2, h.back() / 8.0);
    for (const auto& [name, scheme] : test::all_schemes()) {
        std::vector<double> errors;
        for (const double step : h) errors.push_back(std::abs(coordinate(scheme, step) - exact));
        const std::vector<double> found = test::observed_orders(h, errors);
        test::record(std::string(name) + "_undamped_errors", errors);
        test::record(std::string(name) + "_undamped_orders", found);
        EXPECT_GT(found.back(), scheme.integrator == Integrator::implicit_euler ? 0.75 : 1.8) << name;
    }
}

/// A force that comes and goes inside steps, with a velocity force: its jumps end steps, so the order stays.
TEST(Jumps, LoadsThatJumpInsideAStepKeepTheOrder) {
    test::BeamSpec spec = coarse_beam();
    spec.damping_s = 0.004;
    model::Model model = test::make_beam(spec);
    model.velocity_force_1_s = -30.0;
    test::push_tip(model, spec, {0.0, 0.0, 0.6});
    model.forces.back().from_s = 0.0313;
    model.forces.back().until_s = 0.0777;
    for (const auto& [name, scheme] : test::all_schemes())
        EXPECT_GT(orders(model, scheme, {0.005, 0.0025, 0.00125}, 0.11, name).back(),
                  scheme.integrator == Integrator::implicit_euler ? 0.75 : 1.8)
            << name;
    const Trace trace = run(model, Integrator::tr_bdf2, 0.01, 0.11);
    EXPECT_EQ(std::count(trace.times_s.begin(), trace.times_s.end(), 0.0313), 1);
    EXPECT_EQ(std::count(trace.times_s.begin(), trace.times_s.end(), 0.0777), 1);
    EXPECT_EQ(trace.times_s.size(), 14u);  // start, eleven steps, two jumps
}

TEST(Jumps, ActivationStepsKeepTheOrder) {
    test::BeamSpec spec = coarse_beam();
    spec.damping_s = 0.004;
    model::Model model = test::make_beam(spec);
    add_muscle(model, fibre::Signal::step(0.0237, 1.0, 0.8));
    for (const auto& [name, scheme] : test::all_schemes())
        EXPECT_GT(orders(model, scheme, {0.0025, 0.00125, 0.000625}, 0.08, name).back(),
                  scheme.integrator == Integrator::implicit_euler ? 0.75 : 1.8)
            << name;
}

/// A weight on a thread for part of the run, another one from a later time on, eight times as heavy as the beam
/// together.
model::Model with_passing_masses(const test::BeamSpec& spec, double from_s, double until_s) {
    model::Model model = test::make_beam(spec);
    const double body_kg = spec.density_kg_m3 * spec.size.prod();
    for (const double kg : {2.0 * body_kg, 6.0 * body_kg})
        model.directional_masses.push_back(model::line_mass(test::tip_share(model, spec), {0.3, 0.2, 1.0}, kg));
    model.directional_masses[0].until_s = until_s;
    model.directional_masses[1].from_s = from_s;
    return model;
}

TEST(Jumps, MassesThatJoinAndLeaveInsideAStepKeepTheOrder) {
    test::BeamSpec spec = coarse_beam();
    spec.damping_s = 0.004;
    model::Model model = with_passing_masses(spec, 0.0777, 0.0313);
    model.velocity_force_1_s = -10.0;
    for (const auto& [name, scheme] : test::all_schemes())
        EXPECT_GT(orders(model, scheme, {0.0025, 0.00125, 0.000625, 0.0003125}, 0.11, name).back(),
                  scheme.integrator == Integrator::implicit_euler ? 0.75 : 1.8)
            << name;
}

/// Where its mass changes the body goes on from where it is, with the velocity that it has.
TEST(Jumps, OfAMassHandOverPositionsAndVelocities) {
    const test::BeamSpec spec = coarse_beam();
    const model::Model model = with_passing_masses(spec, 0.08, 0.04);
    // What it is within each of the spans, for ever.
    const std::vector<std::vector<std::size_t>> present{{0}, {}, {1}};
    SimulationOptions options;
    options.h_s = 0.005;
    options.end_s = 0.04;
    options.solver.tolerance = 1e-10;
    for (const TimeScheme& scheme : {TimeScheme(Integrator::tr_bdf2), TimeScheme(Integrator::implicit_euler),
                                     TimeScheme(Integrator::trapezoidal)}) {
        options.integrator = scheme;
        options.initial = {};
        SimulationOptions whole_options = options;
        whole_options.end_s = 0.12;
        const Trace whole = simulate(model, whole_options);
        ASSERT_TRUE(whole.complete()) << whole.message;
        const double motion = (whole.positions[8] - model.body->mesh.nodes).norm();
        for (std::size_t span = 0; span < present.size(); ++span) {
            model::Model part_model = test::make_beam(spec);
            for (const std::size_t k : present[span])
                part_model.directional_masses.push_back({model.directional_masses[k].inertia_kg});
            const Trace part = simulate(part_model, options);
            ASSERT_TRUE(part.complete()) << part.message;
            EXPECT_LT((part.positions.back() - whole.positions[8 * (span + 1)]).norm(), 1e-7 * motion)
                << to_string(scheme.integrator) << span;
            EXPECT_LT((part.velocities.back() - whole.velocities[8 * (span + 1)]).norm(),
                      1e-6 * whole.velocities[8].norm())
                << to_string(scheme.integrator) << span;
            options.initial = {part.positions.back(), part.velocities.back()};
        }
    }
}

/// The mass of a step is that of its middle: its ends may lie on the wrong side of a jump by rounding.
TEST(Jumps, OfAMassWithinRoundingOfAStepEndAreThatStepEnd) {
    const test::BeamSpec spec = coarse_beam();
    for (const double time : {0.0, 0.03}) {
        const Trace aligned = run(with_passing_masses(spec, time, time), Integrator::tr_bdf2, 0.01, 0.06);
        for (const double shift : {1e-12, 4e-18, -4e-18, -1e-12}) {
            // Two jumps within rounding of each other are one.
            const model::Model model = with_passing_masses(spec, time + shift, time - shift);
            const Trace shifted = run(model, Integrator::tr_bdf2, 0.01, 0.06);
            ASSERT_EQ(shifted.times_s.size(), aligned.times_s.size()) << shift;
            const double motion = (aligned.positions.back() - model.body->mesh.nodes).norm();
            EXPECT_LT((shifted.positions.back() - aligned.positions.back()).norm(), 1e-7 * motion)
                << time << " " << shift;
        }
    }
}

/// A jump within rounding of the end of a step, on either side, or of the start, is the jump there.
TEST(Jumps, WithinRoundingOfAStepEndAreThatStepEnd) {
    test::BeamSpec spec = coarse_beam();
    model::Model model = test::make_beam(spec);
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
            EXPECT_LT((shifted.positions.back() - aligned.positions.back()).norm(), 1e-8 * motion)
                << time << " " << shift;
        }
    }
}

/// A jump close to a step end takes its place: no step is so short that rounding would show in its accelerations.
TEST(Jumps, BesideAStepEndLeaveNoTinyStep) {
    test::BeamSpec spec = coarse_beam();
    model::Model model = test::make_beam(spec);
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
}  // namespace myo::dynamics
