#include <gtest/gtest.h>

#include "model/point_energy.hpp"
#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"
#include "support/figures.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

struct MemoryCase {
    fem::ElementKind kind;
    dynamics::TimeScheme integrator;
    dynamics::StartKind start;
    bool creep = false, softening = false;
    const char* material = "neo_hookean";
};

/// The driven beam with memory: softening that begins at the energies of its motion.
model::Model remembering_beam(const MemoryCase& c) {
    model::Model model = test::driven_beam(c.kind, c.material);
    if (c.creep) model.creep = material::MaxwellBranch{0.6, 0.02};
    if (c.softening) model.softening = material::StressSoftening{0.3, 150.0};
    return model;
}

class MemoryAdjoint : public testing::TestWithParam<MemoryCase> {};

/// Modulus, damping, law and all knots of the signals, over jumps of loads and signals.
TEST_P(MemoryAdjoint, EqualsTheTangents) {
    const MemoryCase c = GetParam();
    const model::Model model = remembering_beam(c);
    dynamics::SimulationOptions options = test::short_run(c.integrator, c.start);
    options.solver.tangent_tolerance = 1e-13;
    const LossOfMotion loss = test::rough_loss(model);
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-13;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    std::vector<ModelTangent> parameters{youngs_modulus_tangent(model, 2.6e5), damping_tangent()};
    std::vector<double> expected{young_gradient(model, run.gradient).youngs_modulus_Pa, run.gradient.damping_s};
    for (std::size_t k = 0; k < model.material->parameters().size(); ++k) {
        parameters.push_back(law_tangent(k));
        expected.push_back(run.gradient.law.at(k));
    }
    for (const std::size_t knot : {1u, 3u, 4u}) {
        ModelTangent tangent;
        tangent.activation = model.activation;
        for (fibre::Signal& signal : tangent.activation) std::fill(signal.values.begin(), signal.values.end(), 0.0);
        tangent.activation[0].values[knot] = 1.0;
        parameters.push_back(tangent);
        expected.push_back(run.gradient.activation[0][knot]);
    }
    const SensitiveTrace tangents = simulate_with_tangents(model, options, parameters, loss.nodes);
    const MotionLoss derivative = loss.evaluate(run.motion);
    double worst = 0.0;
    for (std::size_t p = 0; p < expected.size(); ++p) {
        const double along = test::along(derivative, tangents.tangents[p]);
        EXPECT_NE(along, 0.0);
        worst = std::max(worst, std::abs(expected[p] / along - 1.0));
        EXPECT_NEAR(expected[p] / along, 1.0, 1e-8) << "parameter " << p;
    }
    test::record("worst_error", worst);
}

/// With the start velocities, densities, forces and all else that has no tangent.
TEST_P(MemoryAdjoint, EqualsCentralDifferencesForEveryParameter) {
    const MemoryCase c = GetParam();
    const model::Model model = remembering_beam(c);
    dynamics::SimulationOptions options = test::short_run(c.integrator, c.start);
    options.end_s = 0.02;
    options.initial.velocities = 0.05 * test::rough_field(model.body->node_count(), 0.4);
    const GradientCheck check = check_gradient(model, options, test::rough_loss(model),
                                               checked_parameters(model, options));
    ASSERT_TRUE(check.complete()) << check.message;
    bool identical = true;
    for (const GradientCheckRow& row : check.rows) {
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        // A point whose peak changes its time within the difference has a kink.
        EXPECT_LT(row.relative_error, c.softening ? 1e-4 : 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
        identical = identical && row.adjoint == row.difference;
    }
    EXPECT_FALSE(identical);
    EXPECT_LT(check.median_error(), 1e-6);
    test::record("median_error", check.median_error());
    test::record("worst_error", check.worst_error());
}

constexpr auto straight = dynamics::StartKind::straight, equilibrium = dynamics::StartKind::equilibrium;

INSTANTIATE_TEST_SUITE_P(
    All, MemoryAdjoint,
    testing::Values(
        MemoryCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, straight, true},
        MemoryCase{fem::ElementKind::hex8, dynamics::Integrator::bdf2, equilibrium, true},
        MemoryCase{fem::ElementKind::hex8_mean_dilatation, dynamics::Integrator::implicit_euler, equilibrium, true},
        MemoryCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, straight, false, true},
        MemoryCase{fem::ElementKind::hex8_mean_dilatation, dynamics::Integrator::tr_bdf2, straight, true, true},
        MemoryCase{fem::ElementKind::hex8, dynamics::Integrator::generalized_alpha, straight, true, true}));

/// The derivative by the modulus, by the adjoint and by the tangents.
void expect_derivative_by_modulus(const model::Model& model, dynamics::StartKind start, double bound) {
    dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2, start);
    options.solver.tangent_tolerance = 1e-13;
    const LossOfMotion loss = test::rough_loss(model);
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-13;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    const SensitiveTrace tangents = simulate_with_tangents(model, options, {youngs_modulus_tangent(model, 2.6e5)},
                                                           loss.nodes);
    EXPECT_NEAR(young_gradient(model, run.gradient).youngs_modulus_Pa /
                    test::along(loss.evaluate(run.motion), tangents.tangents[0]),
                1.0, bound);
}

/// Without damping only the branch is viscous.
TEST(MemoryAdjoint, KnowsCreepWithoutDamping) {
    model::Model model = remembering_beam({fem::ElementKind::hex8, {}, straight, true});
    model.damping_s = 0.0;
    expect_derivative_by_modulus(model, straight, 1e-8);
}

/// The start equilibrium softens the body, and depends on that itself. The tangent of the start is iterated to 1e-9.
TEST(MemoryAdjoint, KnowsASofteningStart) {
    expect_derivative_by_modulus(remembering_beam({fem::ElementKind::hex8, {}, equilibrium, true, true}), equilibrium,
                                 1e-7);
}

/// The backward pass repeats parts of the run, and with them what the body remembers.
TEST(MemoryAdjoint, IsTheSameForARunInParts) {
    const model::Model model = remembering_beam(
        {fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, straight, true, true});
    dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2, straight);
    options.end_s = 0.25;
    options.solver.tolerance = 1e-12;
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-12;
    const LossOfMotion loss = test::rough_loss(model);
    const GradientRun whole = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(whole.complete()) << whole.message;
    adjoint.memory_bytes = 0.8 * whole.tape_bytes;
    const GradientRun parts = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(parts.complete()) << parts.message;
    EXPECT_GT(parts.parts, 1);
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR(parts.gradient.activation[0][k], whole.gradient.activation[0][k],
                    1e-8 * std::abs(whole.gradient.activation[0][3]));
}

/// The work per point's factor is the transpose of the forces per factor; the gradient of the energies that of their
/// changes.
TEST(PointWork, IsTheDerivativeOfForcesAndEnergies) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::hex8_mean_dilatation}) {
        const model::Model model = test::driven_beam(kind);
        const Matrix3Xd X = model.body->mesh.nodes, p = test::rough_field(X.cols(), 0.7);
        const Matrix3Xd x = X + 1e-3 * test::rough_field(X.cols(), 0.2);
        VectorXd direction(model.body->point_count());
        for (Eigen::Index c = 0; c < direction.size(); ++c) direction(c) = std::sin(0.4 + 1.3 * static_cast<double>(c));
        // A lane past the last cell repeats that cell and has no forces.
        VectorXd of_cells = VectorXd::Zero(direction.size());
        for (int c = 0; c < model.body->cell_count(); ++c)
            for (int q = 0; q < model.body->points_per_cell; ++q)
                of_cells(model.body->point_entry(c, q)) = direction(model.body->point_entry(c, q));
        const auto force = [&](double by) {
            model::Stiffness changed = model::stiffness(model);
            changed.fibres = false;
            changed.viscous.clear();
            changed.elastic_factors = VectorXd::Ones(direction.size()) + by * of_cells;
            return model::internal_energy(model, x, {&changed, nullptr, {}, nullptr}, model::HessianKind::none)
                .gradient;
        };
        const double difference = p.cwiseProduct((force(0.5) - force(-0.5))).sum();
        EXPECT_NE(difference, 0.0);
        EXPECT_NEAR(model::point_factor_work(model, x, p).dot(of_cells), difference, 1e-10 * std::abs(difference));
        const auto energy = [&](double by) {
            return of_cells.dot(model::isochoric_energy_densities(model, x + by * p));
        };
        const double slope = (energy(1e-6) - energy(-1e-6)) / 2e-6;
        EXPECT_NE(slope, 0.0);
        EXPECT_NEAR(model::isochoric_energy_gradient(model, x, of_cells).cwiseProduct(p).sum(), slope,
                    1e-6 * std::abs(slope));
    }
}

}  // namespace
}  // namespace myo::sensitivity
