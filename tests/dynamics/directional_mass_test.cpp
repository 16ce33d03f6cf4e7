#include <gtest/gtest.h>

#include "dynamics/energy.hpp"
#include "dynamics/statics.hpp"
#include "model/directional_mass.hpp"
#include "model/loaded_face.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::run;

test::BeamSpec beam() {
    test::BeamSpec spec;
    spec.cells = {5, 2, 2};
    return spec;
}

double body_mass(const test::BeamSpec& spec) { return spec.density_kg_m3 * spec.size.prod(); }

/// A mass along each of three lines is one that resists alike along every direction, whatever lines at right angles
/// they are.
TEST(DirectionalMass, AlongThreeLinesMovesAsAnAttachedOneWithoutWeight) {
    const test::BeamSpec spec = beam();
    model::Model attached = test::make_beam(spec);
    attached.velocity_force_1_s = 1.0;
    test::push_tip(attached, spec, {0.1, 0.2, -0.15});
    model::Model directional = attached;
    const Eigen::VectorXd share = test::tip_share(attached, spec);
    const double kg = 2.0 * body_mass(spec);
    attached.masses.push_back({share, kg});
    const Eigen::Matrix3d Q = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    for (int r = 0; r < 3; ++r) directional.directional_masses.push_back(model::line_mass(share, Q.col(r), kg));
    for (const auto& [name, scheme] : test::all_schemes()) {
        const double found = test::relative_difference(run(attached, scheme, 0.01, 0.2),
                                                       run(directional, scheme, 0.01, 0.2));
        test::record(name, found);
        EXPECT_LT(found, 1e-6) << name;
    }
}

TEST(DirectionalMass, GivesTheSameMotionByEveryStrategy) {
    test::BeamSpec spec = beam();
    spec.gravity_m_s2 = 9.81;
    model::Model model = test::make_beam(spec);
    model.directional_masses = {model::added_mass(*model.body, model::free_faces(*model.body), 30.0),
                                model::added_mass(*model.body, model::free_faces(*model.body), 80.0)};
    model.directional_masses[1].until_s = 0.1;
    SimulationOptions options;
    options.h_s = 0.01;
    options.end_s = 0.2;
    options.solver.tolerance = 1e-9;
    const auto by = [&](Strategy strategy) {
        options.solver.strategy = strategy;
        const Trace trace = simulate(model, options);
        EXPECT_TRUE(trace.complete()) << to_string(strategy) << ": " << trace.message;
        return trace;
    };
    const Trace newton = by(Strategy::newton);
    for (const Strategy strategy : {Strategy::automatic, Strategy::lagged_newton, Strategy::projective})
        EXPECT_LT(test::relative_difference(newton, by(strategy)), 1e-6) << to_string(strategy);
}

TEST(DirectionalMass, SlowsTheModeThatMovesAlongItAsAnAttachedOneAndLeavesTheOther) {
    const test::BeamSpec spec = test::ringing_beam();
    const model::Model bare = test::make_beam(spec);
    const auto modes = [](const model::Model& model) {
        StageSolver solver(model);
        const NaturalModes found = natural_modes(solver, model.body->mesh.nodes, 2);
        EXPECT_TRUE(found.ok());
        return found.modes;
    };
    const Eigen::VectorXd share = test::tip_share(bare, spec);
    model::Model attached = bare, line = bare, plane = bare;
    attached.masses.push_back({share, 0.5 * body_mass(spec)});
    line.directional_masses.push_back(model::line_mass(share, Vector3d::UnitZ(), 0.5 * body_mass(spec)));
    plane.directional_masses = line.directional_masses;
    plane.directional_masses.push_back(model::line_mass(share, Vector3d::UnitX(), 0.5 * body_mass(spec)));
    const auto without = modes(bare), with_attached = modes(attached), with_line = modes(line),
               with_plane = modes(plane);
    EXPECT_LT(with_attached[0].omega_rad_s, 0.7 * without[0].omega_rad_s);
    EXPECT_NEAR(with_plane[0].omega_rad_s / with_attached[0].omega_rad_s, 1.0, 1e-4)
        << "bends along z, the thick tip turns";
    EXPECT_GT(with_line[0].omega_rad_s, with_plane[0].omega_rad_s) << "the turn meets no inertia";
    EXPECT_NEAR(with_line[0].omega_rad_s / with_attached[0].omega_rad_s, 1.0, 0.02);
    EXPECT_NEAR(with_line[1].omega_rad_s / without[1].omega_rad_s, 1.0, 2e-3) << "bends along y";
}

/// A fluid layer on the two broad sides of a slender beam moves as more density does.
TEST(DirectionalMass, OfAFluidSlowsASlenderBeamAsBeamTheorySays) {
    test::BeamSpec spec = beam();
    spec.cells = {30, 1, 2};
    spec.size = {0.4, 0.04, 0.01};
    spec.poissons_ratio = 0.0;
    model::Model model = test::make_beam(spec);
    const double before = test::first_mode(model).omega_rad_s, per_area = 0.8 * spec.density_kg_m3 * spec.size(2);
    model.directional_masses = {model::added_mass(*model.body, model::free_faces(*model.body), per_area)};
    // Along z: mass per length rho b h + 2 m b.
    const double expected = std::sqrt(1.0 / (1.0 + 2.0 * per_area / (spec.density_kg_m3 * spec.size(2))));
    const double found = test::first_mode(model).omega_rad_s / before;
    test::record("ratio_error", found / expected - 1.0);
    EXPECT_NEAR(found / expected, 1.0, 2e-3);
}

TEST(DirectionalMass, LeavesTheEquilibriumWhereItIs) {
    test::BeamSpec spec = beam();
    spec.gravity_m_s2 = 9.81;
    model::Model model = test::make_beam(spec);
    const auto equilibrium = [&] {
        SolverOptions options;
        options.tolerance = 1e-10;
        StageSolver solver(model, options);
        Matrix3Xd x = model.body->mesh.nodes;
        EXPECT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
        return x;
    };
    const Matrix3Xd before = equilibrium();
    model.directional_masses = {model::added_mass(*model.body, model::free_faces(*model.body), 50.0)};
    EXPECT_GT((before - model.body->mesh.nodes).norm(), 1e-3);
    EXPECT_LT((equilibrium() - before).norm(), 1e-9 * before.norm());
}

/// Undamped, the trapezoidal rule keeps the energy of a vibration to the second order; kinetic energy lacks most of it
/// where the directional part is left out.
TEST(DirectionalMass, KeepsTheEnergyOfAnUndampedVibration) {
    const test::BeamSpec spec = test::ringing_beam();
    model::Model model = test::make_beam(spec);
    model.directional_masses = {model::added_mass(*model.body, model::free_faces(*model.body), 20.0)};
    const model::MassMatrix mass = model::mass_matrix(model);
    const NaturalMode mode = test::first_mode(model);
    SimulationOptions options;
    options.integrator = Integrator::trapezoidal;
    options.solver.tolerance = 1e-10;
    options.initial.velocities = 1e-3 * mode.omega_rad_s / mode.shape.cwiseAbs().maxCoeff() * mode.shape;
    options.end_s = 12.0 / mode.omega_rad_s;
    std::vector<double> steps, drift;
    for (const double parts : {20.0, 40.0, 80.0}) {
        options.h_s = 6.0 / (parts * mode.omega_rad_s);
        const Trace trace = simulate(model, options);
        ASSERT_TRUE(trace.complete()) << trace.message;
        double worst = 0.0, min_kinetic = 1e300;
        const double first = energy(model, mass, trace.positions[0], trace.velocities[0], 0.0).total_J();
        for (std::size_t n = 0; n < trace.times_s.size(); ++n) {
            const Energy now = energy(model, mass, trace.positions[n], trace.velocities[n], trace.times_s[n]);
            worst = std::max(worst, std::abs(now.total_J() / first - 1.0));
            min_kinetic = std::min(min_kinetic, now.kinetic_J / first);
        }
        EXPECT_LT(min_kinetic, 0.1) << "kinetic energy turns into elastic energy";
        steps.push_back(options.h_s);
        drift.push_back(worst);
    }
    test::record("drift", drift);
    EXPECT_LT(drift.front(), 1e-3);
    EXPECT_LT(drift.back(), 1e-4);
}

}  // namespace
}  // namespace myo::dynamics
