#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/energy.hpp"
#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"
#include "support/figures.hpp"
#include "support/hollow.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using testing::HasSubstr;

/// The model under a constant pressure, on an outer bed too soft to matter that keeps it in place.
model::Model under_pressure(model::Model model, double E, double nu, double pressure_Pa) {
    const model::Body& body = *model.body;
    model.moduli = model::uniform_moduli(body.cell_count(), E, nu);
    const std::vector<int> walls = model::closed_cavities(body).at(0);
    std::vector<int> outer;
    for (int f = 0; f < static_cast<int>(body.boundary.count()); ++f)
        if (std::find(walls.begin(), walls.end(), f) == walls.end()) outer.push_back(f);
    model.force_elements = {model::cavity_pressure(body, walls, fibre::Signal::constant(pressure_Pa), "chamber upper"),
                            model::elastic_bed(body, outer, 1.0)};
    return model;
}

/// Lame's thick tube with closed ends: the inner radius grows by p a / (E (b^2 - a^2)) ((1 - 2 nu) a^2 + (1 + nu) b^2).
TEST(CavityPressure, WidensAThickTubeAsLameSays) {
    const double a = 0.01, b = 0.02, half = 0.06, E = 2e5, nu = 0.45, p = 20.0;
    const double lame = p * a / (E * (b * b - a * a)) * ((1.0 - 2.0 * nu) * a * a + (1.0 + nu) * b * b);
    std::vector<double> errors;
    for (const int cells : {6, 12}) {
        const model::Model model = under_pressure(test::hollow_tube(a, b, half, cells, 2 * cells), E, nu, p);
        StageSolver solver(model);
        const Matrix3Xd& X = model.body->mesh.nodes;
        Matrix3Xd x = X;
        ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
        double grown = 0.0;
        int count = 0;
        // Two radii from its ends the tube does not feel them.
        for (Eigen::Index i = 0; i < X.cols(); ++i)
            if (std::abs(X(2, i)) < half - 4.0 * a && std::abs(X.col(i).head<2>().norm() - a) < 1e-9) {
                grown += x.col(i).head<2>().norm() - a;
                ++count;
            }
        ASSERT_GT(count, 0);
        errors.push_back(grown / count / lame - 1.0);
    }
    // Flat faces hold less than the tube: the error falls with the square of their size.
    test::record("error_of_the_inner_radius", errors);
    EXPECT_LT(std::abs(errors[1]), 0.07);
    EXPECT_LT(std::abs(errors[1]), 0.4 * std::abs(errors[0]));
    EXPECT_NEAR((4.0 * errors[1] - errors[0]) / 3.0, 0.0, 0.02);
}

/// Pressure of an incompressible neo-Hookean sphere over mu, at the stretch of its inner radius a; b / a = `ratio`.
double inflating_pressure(double stretch, double ratio) {
    const double cube = ratio * ratio * ratio;
    const double outer = std::cbrt(1.0 + (stretch * stretch * stretch - 1.0) / cube);
    const auto of = [](double s) { return 2.0 / s + 0.5 / (s * s * s * s); };
    return of(outer) - of(stretch);
}

/// Large strain: the pressure of the closed form at the stretch that the sphere shows. Stretches and radii are those of
/// spheres with the volumes of the mesh, so that flat faces matter little.
TEST(CavityPressure, InflatesANeoHookeanSphereAsTheClosedFormSays) {
    const double a = 0.015, nu = 0.499, E = 3e5, mu = E / (2.0 * (1.0 + nu)), pressure = 0.4 * mu;
    std::vector<double> errors, stretches;
    for (const int cells : {6, 9}) {
        const model::Model model = under_pressure(test::hollow_sphere(a, 1.5 * a, cells), E, nu, pressure);
        const model::Body& body = *model.body;
        const std::vector<int> walls = model::closed_cavities(body).at(0);
        const double volume = model::cavity_volume(body, walls, body.mesh.nodes);
        StageSolver solver(model);
        Matrix3Xd x = body.mesh.nodes;
        ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
        stretches.push_back(std::cbrt(model::cavity_volume(body, walls, x) / volume));
        const double ratio = std::cbrt((volume + body.volume_m3) / volume);
        errors.push_back(mu * inflating_pressure(stretches.back(), ratio) / pressure - 1.0);
    }
    test::record("stretches", stretches);
    test::record("errors_of_the_pressure", errors);
    EXPECT_GT(stretches[1], 1.15);
    EXPECT_NEAR(errors[1], 0.0, 0.03);
    EXPECT_LT(std::abs(errors[1]), 0.6 * std::abs(errors[0]));
}

/// Beyond the largest pressure of the closed form, 0.494 mu, there is no equilibrium: one sentence names the chamber
/// and the pressure at which it was lost, and nothing is NaN.
TEST(CavityPressure, ThatRunsAwayIsNamed) {
    const double a = 0.015, ratio = 1.5, nu = 0.49, E = 3e5, mu = E / (2.0 * (1.0 + nu));
    const model::Model model = under_pressure(test::hollow_sphere(a, ratio * a, 3), E, nu, 2.0 * mu);
    SolverOptions options;
    options.max_newton_iterations = 10;  // of each method, none of which can succeed
    StageSolver solver(model, options);
    Matrix3Xd x = model.body->mesh.nodes;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    ASSERT_FALSE(report.ok());
    EXPECT_TRUE(x.allFinite());
    EXPECT_THAT(report.message, testing::AllOf(HasSubstr("no equilibrium was found under"),
                                               HasSubstr("Pa in chamber upper"), HasSubstr("gives way")));
    const std::size_t at = report.message.find("under ");
    const double lost = std::stod(report.message.substr(at + 6));
    test::record("lost_at_over_mu", lost / mu);
    // The coarse sphere, of one cell across its hole, holds less volume and is stiffer.
    EXPECT_GT(lost / mu, 0.45);
    EXPECT_LT(lost / mu, 1.2);
}

/// A body without damping under a constant pressure keeps its energy, to which the pressure contributes -p V.
TEST(CavityPressure, ConservesTheEnergyOfAConstantPressure) {
    model::Model model = test::hollow_block(fem::ElementKind::hex8);
    const model::Body& body = *model.body;
    const std::vector<int> walls = model::closed_cavities(body).at(0);
    const double p = 2e4;
    model.force_elements = {model::cavity_pressure(body, walls, fibre::Signal::constant(p))};
    std::vector<double> drift;
    for (const double h_s : {1e-3, 5e-4}) {
        SimulationOptions options;
        options.integrator = Integrator::trapezoidal;
        options.h_s = h_s;
        options.end_s = 0.03;
        const Trace trace = simulate(model, options);
        ASSERT_TRUE(trace.complete()) << trace.message;
        const model::MassMatrix mass = model::mass_matrix(model);
        double first = 0.0, off = 0.0, kinetic = 0.0, worked = 0.0;
        for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
            const Energy now = energy(model, mass, trace.positions[k], trace.velocities[k], trace.times_s[k]);
            if (k == 0) first = now.total_J();
            off = std::max(off, std::abs(now.total_J() - first));
            kinetic = std::max(kinetic, now.kinetic_J);
            worked = std::max(worked,
                              p * (model::cavity_volume(body, walls, trace.positions[k]) - test::hollow_volume_m3));
        }
        EXPECT_GT(worked, kinetic) << "the pressure drives the motion";
        drift.push_back(off / kinetic);
    }
    test::record("energy_drift_over_kinetic", drift);
    EXPECT_LT(drift[1], 0.05);
    EXPECT_LT(drift[1], 0.5 * drift[0]);
}

}  // namespace
}  // namespace myo::dynamics
