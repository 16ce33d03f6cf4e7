#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/linearised_step.hpp"
#include "dynamics/material_damping.hpp"
#include "dynamics/numerical_damping.hpp"
#include "dynamics/statics.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

constexpr double swing_rad_s = 48.7;
using test::paper_steps;

double radius(const Matrix2d& A) {
    const auto [first, second] = test::step_eigenvalues(A.cast<std::complex<double>>());
    return std::max(std::abs(first), std::abs(second));
}

TEST(CriticalVelocityForce, OfImplicitEulerIsTheEdgeOfTheTwoByTwoSystem) {
    for (const double h : paper_steps) {
        const double critical = implicit_euler_critical_velocity_force(swing_rad_s, h);
        const double D = 1.0 + h * h * swing_rad_s * swing_rad_s;
        Matrix2d of_the_start, of_the_end;
        for (const double factor : {0.999, 1.001}) {
            const double L = factor * critical;
            of_the_start << 1.0, h * (1.0 + h * L), -h * swing_rad_s * swing_rad_s, 1.0 + h * L;
            of_the_end << 1.0 - h * L, h, -h * swing_rad_s * swing_rad_s, 1.0;
            EXPECT_EQ(radius(of_the_start / D) > 1.0, factor > 1.0) << h;
            EXPECT_EQ(radius(of_the_end / (D - h * L)) > 1.0, factor > 1.0) << h;
        }
        EXPECT_NEAR(critical_velocity_force(Integrator::implicit_euler, swing_rad_s, h), critical, 1e-6 * swing_rad_s)
            << h;
        const double damped = implicit_euler_critical_velocity_force(swing_rad_s, h, 0.055);
        EXPECT_NEAR(critical_velocity_force(Integrator::implicit_euler, swing_rad_s, h, 0.055), damped,
                    1e-6 * swing_rad_s)
            << h;
    }
}

/// The others have only what they damp numerically to spare, and all of the material's damping 2 zeta omega.
TEST(CriticalVelocityForce, OfTheOtherSchemesIsTheirDamping) {
    for (const auto& [name, scheme] : test::all_schemes()) {
        if (scheme.integrator == Integrator::implicit_euler) continue;
        const double h = 0.01, zeta = discrete_vibration(scheme, {swing_rad_s}, h).damping_ratio;
        const double critical = critical_velocity_force(scheme, swing_rad_s, h),
                     damped = critical_velocity_force(scheme, swing_rad_s, h, 0.055);
        test::record(name + std::string("_1_s"), critical);
        EXPECT_NEAR(critical, 2.0 * zeta * swing_rad_s, 0.15 * critical + 1e-6 * swing_rad_s) << name;
        EXPECT_NEAR(damped - critical, 2.0 * 0.055 * swing_rad_s, 1e-5 * swing_rad_s) << name;
    }
}

/// The body's linearised step has the bound of its first mode's oscillator.
TEST(CriticalVelocityForce, OfTheBeamByPowerIterationIsThatOfItsFirstMode) {
    const model::Model model = test::make_beam(test::ringing_beam());
    StageSolver solver(model);
    const Matrix3Xd& X = model.body->mesh.nodes;
    std::vector<double> found;
    for (const double h : paper_steps) {
        const CriticalVelocityForce critical = critical_velocity_force(solver, X, 0.0, Integrator::implicit_euler, h);
        ASSERT_EQ(critical.status, SolveStatus::converged) << h;
        found.push_back(critical.velocity_force_1_s);
        EXPECT_NEAR(found.back() / implicit_euler_critical_velocity_force(critical.omega_rad_s, h), 1.0, 1e-6) << h;
    }
    test::record("implicit_euler_1_s", found);
    for (const auto& [name, scheme] : test::all_schemes()) {
        const CriticalVelocityForce critical = critical_velocity_force(solver, X, 0.0, scheme, 0.01);
        ASSERT_EQ(critical.status, SolveStatus::converged) << name;
        test::record(std::string(name) + "_at_10_ms_1_s", critical.velocity_force_1_s);
        test::record(std::string(name) + "_steps", critical.steps);
        EXPECT_NEAR(critical.velocity_force_1_s, critical_velocity_force(scheme, critical.omega_rad_s, 0.01),
                    1e-5 * swing_rad_s)
            << name;
    }
}

/// From a displacement with a part of every mode of the plane, at the bound of the first: none grows faster. Across the
/// plane the beam bends at a frequency so near that the iteration would take long.
TEST(CriticalVelocityForce, IsTheFirstModesAlsoFromADisplacementOfManyModes) {
    const model::Model model = test::make_beam(test::ringing_beam());
    StageSolver solver(model);
    const Matrix3Xd& X = model.body->mesh.nodes;
    Matrix3Xd u = test::first_mode(model).shape;
    for (const int i : model.body->pattern.free_nodes)
        u.col(i) += 0.1 * Eigen::Vector3d(std::sin(150.0 * X(0, i) + 90.0 * X(2, i)), 0.0,
                                          std::cos(210.0 * X(0, i) - 70.0 * X(2, i)));
    for (const auto& [name, scheme] : test::all_schemes()) {
        if (scheme.integrator == Integrator::trapezoidal || scheme.rho_inf > 0.8) continue;  // fast modes hardly decay
        const double critical = critical_velocity_force(solver, X, 0.0, scheme, 0.01).velocity_force_1_s;
        LinearisedStep step(solver, X, 0.0, scheme, 0.01, critical);
        const GrowthPerStep growth = growth_per_step(step, u);
        EXPECT_EQ(growth.status, SolveStatus::converged) << name << " " << growth.residual;
        EXPECT_NEAR(growth.spectral_radius, 1.0, 1e-7) << name;
        test::record(std::string(name) + "_steps", growth.steps);
    }
}

/// About the equilibrium under gravity, with damping: Lambda_crit = h omega^2 + 2 zeta omega, zeta the material's.
TEST(CriticalVelocityForce, OfTheDampedSaggedBeam) {
    test::BeamSpec spec = test::ringing_beam();
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.002;
    const model::Model model = test::make_beam(spec);
    StageSolver solver(model);
    Matrix3Xd x = model.body->mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    const CriticalVelocityForce critical = critical_velocity_force(solver, x, 0.0, Integrator::implicit_euler, 0.01);
    ASSERT_EQ(critical.status, SolveStatus::converged);
    const NaturalModes modes = natural_modes(solver, x, 1);
    ASSERT_TRUE(modes.ok());
    const double zeta = damping_ratio(damping_factor(model, x, modes.modes[0]), spec.damping_s, critical.omega_rad_s);
    EXPECT_NEAR(critical.velocity_force_1_s / implicit_euler_critical_velocity_force(critical.omega_rad_s, 0.01, zeta),
                1.0, 0.01);
}

/// Amplitude of the end of a run over that of its first half.
double growth(double lambda, const TimeScheme& scheme, double h) {
    model::Model model = test::held(test::ringing_beam());
    model.velocity_force_1_s = lambda;
    const VectorXd q = test::ring(model, test::first_mode(model), scheme, h, 200);
    if (q.size() == 0) return 0.0;
    return q.tail(50).cwiseAbs().maxCoeff() / q.segment(50, 50).cwiseAbs().maxCoeff();
}

TEST(CriticalVelocityForce, ARunSlightlyBelowDecaysAndSlightlyAboveGrows) {
    const model::Model model = test::make_beam(test::ringing_beam());
    StageSolver solver(model);
    for (const double h : {0.005, 0.01, 0.02}) {
        const double critical = critical_velocity_force(solver, model.body->mesh.nodes, 0.0, Integrator::implicit_euler,
                                                        h)
                                    .velocity_force_1_s;
        const double below = growth(0.97 * critical, Integrator::implicit_euler, h),
                     above = growth(1.03 * critical, Integrator::implicit_euler, h);
        test::record("implicit_euler_growth_at_ms_" + std::to_string(static_cast<int>(1e3 * h)), {below, above});
        EXPECT_LT(below, 0.95) << h;
        EXPECT_GT(above, 1.05) << h;
    }
    const double critical = critical_velocity_force(solver, model.body->mesh.nodes, 0.0, Integrator::bdf2, 0.01)
                                .velocity_force_1_s;
    EXPECT_LT(growth(0.9 * critical, Integrator::bdf2, 0.01), 0.95);
    EXPECT_GT(growth(1.1 * critical, Integrator::bdf2, 0.01), 1.05);
}

}  // namespace
}  // namespace myo::dynamics
