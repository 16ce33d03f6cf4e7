#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "dynamics/creep.hpp"
#include "dynamics/energy.hpp"
#include "dynamics/linearised_step.hpp"
#include "dynamics/statics.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"
#include "support/pulled_block.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using test::run;

/// Strain per stress of the standard linear solid: the shear creeps, the volume does not.
double compliance(const material::Moduli& m, const material::MaxwellBranch& branch, double t) {
    const double g = branch.modulus_ratio, tau_of_creep = branch.relaxation_time_s * (1.0 + g);
    return (1.0 - g / (1.0 + g) * std::exp(-t / tau_of_creep)) / (3.0 * m.mu) + 1.0 / (9.0 * m.kappa);
}

/// Under a sudden load a block answers with the stiffness of network and branch, then creeps to that of the network.
TEST(Creep, ASuddenlyPulledBlockFollowsItsCreepFunction) {
    for (const char* element : {"hex8", "tet10"})
        for (const double nu : {0.3, 0.499}) {
            test::BeamSpec spec = test::light_cube();
            spec.kind = test::element(element);
            spec.poissons_ratio = nu;
            model::Model model = test::make_beam(spec);
            model.creep = material::MaxwellBranch{0.8, 0.1};
            test::pull(model, spec, 1.0);  // strains of 1e-5
            // From the sixth step on: before, the block still swings a little, faster than the steps.
            const Trace trace = run(model, Integrator::tr_bdf2, 0.0005, 0.5);
            ASSERT_TRUE(trace.complete()) << trace.message;
            double worst = 0.0;
            for (std::size_t n = 6; n < trace.times_s.size(); ++n) {
                const double exact = compliance(model.moduli[0], *model.creep, trace.times_s[n]);
                worst = std::max(worst, std::abs(test::stretch_of(model, spec, trace.positions[n]) / exact - 1.0));
            }
            test::record(std::string(element) + "_nu_" + std::to_string(static_cast<int>(1e3 * nu)), worst);
            EXPECT_LT(worst, 3e-5) << element << " " << nu;
            const double at_once = test::stretch_of(model, spec, trace.positions[4]),
                         at_last = test::stretch_of(model, spec, trace.positions.back());
            EXPECT_GT(at_last, 1.5 * at_once);
        }
}

test::BeamSpec damped_beam() {
    test::BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.002;
    return spec;
}

model::Model creeping(const test::BeamSpec& spec) {
    model::Model model = test::make_beam(spec);
    model.creep = material::MaxwellBranch{0.7, 0.04};
    return model;
}

TEST(Creep, KeepsTheOrderOfEveryScheme) {
    const model::Model model = creeping(damped_beam());
    const std::vector<double> h{0.005, 0.0025, 0.00125};
    const Trace reference = run(model, Integrator::tr_bdf2, h.back() / 8.0, 0.16);
    // At several times: at a single one an error may pass through zero.
    const auto error_of = [&](const Trace& trace) {
        double sum = 0.0;
        const std::size_t steps = trace.positions.size() - 1, fine = (reference.positions.size() - 1) / steps;
        for (std::size_t part = 1; part <= 4; ++part)
            sum += (trace.positions[part * steps / 4] - reference.positions[part * steps / 4 * fine]).norm();
        return sum;
    };
    for (const auto& [name, scheme] : test::all_schemes()) {
        std::vector<double> errors;
        for (const double step : h) errors.push_back(error_of(run(model, scheme, step, 0.16)));
        const std::vector<double> found = test::observed_orders(h, errors);
        test::record(std::string(name) + "_orders", found);
        EXPECT_GT(found.back(), scheme.integrator == Integrator::implicit_euler ? 0.75 : 1.8) << name;
    }
}

/// Jumps leave strains of body and dashpots as they are.
TEST(Creep, KeepsTheOrderOverAJumpOfTheLoads) {
    const test::BeamSpec spec = damped_beam();
    model::Model model = creeping(spec);
    test::push_tip(model, spec, {0.0, 0.0, 0.6});
    model.forces.back().from_s = 0.0313;
    model.forces.back().until_s = 0.0777;
    const std::vector<double> h{0.005, 0.0025, 0.00125};
    const Matrix3Xd reference = run(model, Integrator::tr_bdf2, h.back() / 8.0, 0.11).positions.back();
    std::vector<double> errors;
    for (const double step : h)
        errors.push_back((run(model, Integrator::tr_bdf2, step, 0.11).positions.back() - reference).norm());
    EXPECT_GT(test::observed_orders(h, errors).back(), 1.8);
}

TEST(Creep, ABodyAtEquilibriumIsRelaxedAndStaysAtRest) {
    const model::Model model = creeping(damped_beam());
    const Trace trace = simulate(model, test::short_steps(StartKind::equilibrium, 0.005, 0.2));
    ASSERT_TRUE(trace.complete()) << trace.message;
    const double sag = (trace.positions.front() - model.body->mesh.nodes).norm();
    EXPECT_GT(sag, 1e-3);
    for (const Matrix3Xd& x : trace.positions) EXPECT_LT((x - trace.positions.front()).norm(), 1e-7 * sag);
}

/// Let go, the creeping beam comes to rest where statics, which knows no branch, puts it.
TEST(Creep, EndsAtTheEquilibriumOfTheNetwork) {
    model::Model model = creeping(damped_beam());
    model.damping_s = 0.01;
    const Trace sagging = simulate(model, test::short_steps(StartKind::straight, 0.01, 3.0));
    const Trace at_rest = simulate(model, test::short_steps(StartKind::equilibrium, 0.01, 0.01));
    ASSERT_TRUE(sagging.complete() && at_rest.complete());
    const double sag = (at_rest.positions.front() - model.body->mesh.nodes).norm();
    EXPECT_LT((sagging.positions.back() - at_rest.positions.front()).norm(), 1e-5 * sag);
}

TEST(Creep, ABranchWithoutModulusChangesNothing) {
    model::Model model = test::make_beam(damped_beam());
    const SimulationOptions options = test::short_steps(StartKind::straight, 0.005, 0.15);
    const Trace plain = simulate(model, options);
    model.creep = material::MaxwellBranch{0.0, 0.04};
    const Trace without = simulate(model, options);
    model.creep = material::MaxwellBranch{0.7, 0.04};
    const Trace with = simulate(model, options);
    ASSERT_EQ(plain.positions.size(), without.positions.size());
    const double motion = (plain.positions.back() - plain.positions.front()).norm();
    for (std::size_t n = 0; n < plain.positions.size(); ++n)
        EXPECT_LT((plain.positions[n] - without.positions[n]).norm(), 1e-7 * motion);
    EXPECT_GT((plain.positions.back() - with.positions.back()).norm(), 1e-2 * motion);
}

/// A small displacement let go, its dashpots relaxed: the run and its linearised steps.
TEST(Creep, SmallMotionsAreThoseOfTheLinearisedStep) {
    test::BeamSpec spec = damped_beam();
    spec.gravity_m_s2 = 0.0;
    const model::Model model = creeping(spec);
    const Matrix3Xd rest = model.body->mesh.nodes;
    StageSolver solver(model);
    model::Model pushed = model;
    test::push_tip(pushed, spec, {0.0, 0.0, 1e-5});
    StageSolver of_pushed(pushed, {.tolerance = 1e-12});
    Matrix3Xd x = rest;
    ASSERT_TRUE(solve_equilibrium(of_pushed, 0.0, x).ok());
    for (const TimeScheme& scheme : {TimeScheme(Integrator::tr_bdf2), TimeScheme(Integrator::bdf2)}) {
        SimulationOptions options = test::short_steps(StartKind::equilibrium, 0.004, 0.04);
        options.integrator = scheme;
        options.initial.positions = x;
        const Trace trace = simulate(model, options);
        ASSERT_TRUE(trace.complete()) << trace.message;
        LinearisedStep step(solver, rest, 0.0, scheme, options.h_s, 0.0);
        Kinematics deviation = step.displaced(x - rest);
        for (std::size_t n = 1; n < trace.positions.size(); ++n) {
            deviation = step.apply(deviation);
            EXPECT_LT((trace.positions[n] - rest - deviation.x).norm(), 1e-3 * (x - rest).norm()) << n;
        }
    }
}

/// The branch stores energy, and its dashpots take 2 W / tau of it per time: what the body, thick cells and large
/// turns, loses.
TEST(Creep, DashpotsTakeTheEnergyThatTheBodyLoses) {
    for (const char* element : {"hex8", "tet10"}) {
        test::BeamSpec spec = damped_beam();
        spec.kind = test::element(element);
        spec.damping_s = 0.0;
        const model::Model model = creeping(spec);
        const model::MassMatrix mass = model::mass_matrix(model);
        std::vector<double> times, total, stored;
        RunObserver observer;
        observer.reached = [&](const RunPoint& point) {
            const Kinematics& s = point.state;
            times.push_back(point.time_s);
            stored.push_back(branch_energy(model, s.x, s.strain));
            total.push_back(energy(model, mass, s.x, s.v, point.time_s).total_J() + stored.back());
        };
        ASSERT_TRUE(simulate(model, test::short_steps(StartKind::straight, 0.0005, 0.1), {}, observer).complete());
        double taken = 0.0;
        for (std::size_t n = 1; n < times.size(); ++n)
            taken += (times[n] - times[n - 1]) * (stored[n] + stored[n - 1]) / model.creep->relaxation_time_s;
        const double lost = total.front() - total.back();
        test::record(std::string(element) + "_taken_over_lost", taken / lost);
        EXPECT_GT(lost, 1e-4);
        EXPECT_NEAR(taken / lost, 1.0, 0.01) << element;
    }
}

}  // namespace
}  // namespace myo::dynamics
