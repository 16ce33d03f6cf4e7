#include <gtest/gtest.h>

#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double w = 2e5;  // muscle stiffness [Pa]

/// Stretch of a free neo-Hookean bar with fibres along it: dW/ds = 0 with the lateral stretch b from dW/db = 0, by
/// bisection.
double equilibrium_stretch(const material::Moduli& m, double a) {
    const auto lateral_slope = [&](double s, double b) {
        const double J = s * b * b, scale = m.mu * std::pow(J, -2.0 / 3.0), I1 = s * s + 2.0 * b * b;
        return scale * (2.0 * b - 2.0 / 3.0 * I1 / b) + m.kappa / 2.0 * (J - 1.0 / J) * 2.0 * s * b;
    };
    const auto lateral = [&](double s) {
        double low = 0.2, high = 3.0;
        for (int i = 0; i < 200; ++i) (lateral_slope(s, 0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
        return 0.5 * (low + high);
    };
    const auto slope = [&](double s) {
        const double b = lateral(s), J = s * b * b, I1 = s * s + 2.0 * b * b;
        return m.mu * std::pow(J, -2.0 / 3.0) * (s - I1 / (3.0 * s)) + m.kappa / 2.0 * (J - 1.0 / J) * b * b +
               w * (s - a);
    };
    double low = 0.3, high = 2.0;
    for (int i = 0; i < 200; ++i) (slope(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
}

/// The free bar settles, with damping and large implicit steps, at the stretch between rest and target.
TEST(Muscle, FreeBarTakesTheAnalyticStretch) {
    for (const char* element : {"hex8", "tet10"})
        for (const double nu : {0.3, 0.499})
            for (const double a : {0.6, 0.9, 1.3}) {
                test::BeamSpec spec;
                spec.kind = test::element(element);
                spec.cells = {2, 1, 1};
                spec.poissons_ratio = nu;
                spec.damping_s = 0.02;
                spec.clamped = false;
                model::Model model = test::make_beam(spec);
                auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
                fibres->push_back(
                    fibre::fibres_in_box(model.body->mesh, test::beam_box(spec), Vector3d::UnitX(), w, "all"));
                model.fibres = fibres;
                model.activation = {fibre::Signal::constant(a)};
                SimulationOptions options;
                options.integrator = Integrator::implicit_euler;
                options.h_s = 0.05;
                options.end_s = 1.5;
                const Trace trace = simulate(model, options);
                ASSERT_TRUE(trace.complete()) << trace.message;
                // Between two corners: the free body may turn.
                const Matrix3Xd& X = model.body->mesh.nodes;
                Eigen::Index near = 0, far = 0;
                (X.row(0) + X.row(1) + X.row(2)).minCoeff(&near);
                (X.row(0) - X.row(1) - X.row(2)).maxCoeff(&far);
                const double stretch = (trace.positions.back().col(far) - trace.positions.back().col(near)).norm() /
                                       spec.size(0);
                const double exact = equilibrium_stretch(model.moduli.front(), a);
                EXPECT_GT(std::abs(exact - 1.0), 0.03);
                EXPECT_NEAR(stretch, exact, 1e-6) << element << " nu " << nu << " a " << a;
            }
}

/// a = 1 is passive at rest.
TEST(Muscle, RestTargetLeavesTheBodyAtRest) {
    test::BeamSpec spec;
    model::Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(
        fibre::fibres_in_box(model.body->mesh, test::beam_box(spec), Vector3d(1, 1, 1).normalized(), w, "all"));
    model.fibres = fibres;
    model.activation = {fibre::Signal::constant(1.0)};
    StageSolver solver(model);
    Matrix3Xd x = model.body->mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    EXPECT_LT((x - model.body->mesh.nodes).cwiseAbs().maxCoeff(), 1e-12);
}

double bent_tip(const Eigen::Vector3i& cells, double a) {
    test::BeamSpec spec;
    spec.cells = cells;
    model::Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.00375}},
                                           Vector3d::UnitX(), w, "thin"));
    model.fibres = fibres;
    model.activation = {fibre::Signal::constant(a)};
    StageSolver solver(model);
    Matrix3Xd x = model.body->mesh.nodes;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(report.ok()) << cells.transpose() << " " << report.message;
    return test::tip_displacement(model, spec, x)(2);
}

/// A layer an eighth of the height thick, in a quarter or half of a cell, bends as on the mesh that resolves it.
TEST(Muscle, ThinGroupKeepsItsMomentArmOnCoarseCells) {
    const double quarter = bent_tip({13, 2, 2}, 0.9), half = bent_tip({13, 4, 4}, 0.9),
                 resolved = bent_tip({20, 8, 8}, 0.9);
    test::record("tip_resolved_m", resolved);
    test::record("error_quarter_of_a_cell", quarter / resolved - 1.0);
    test::record("error_half_of_a_cell", half / resolved - 1.0);
    EXPECT_LT(resolved, -1e-3);  // contraction below the axis bends down
    EXPECT_NEAR(quarter, resolved, 0.05 * std::abs(resolved));
    EXPECT_NEAR(half, resolved, 0.025 * std::abs(resolved));
    EXPECT_GT(bent_tip({13, 4, 4}, 1.1), 1e-3);
}

}  // namespace
}  // namespace myo::dynamics
