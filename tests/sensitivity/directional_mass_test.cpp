#include "model/directional_mass.hpp"

#include <gtest/gtest.h>

#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"
#include "support/figures.hpp"

namespace myo::sensitivity {
namespace {

struct MassCase {
    fem::ElementKind kind;
    dynamics::TimeScheme scheme;
    dynamics::StartKind start;
};

class DirectionalMassGradient : public testing::TestWithParam<MassCase> {
protected:
    /// Fluid all around and a weight on an oblique thread, many times as heavy as the body.
    DirectionalMassGradient()
        : model(test::driven_beam(GetParam().kind)), options(test::short_run(GetParam().scheme, GetParam().start)) {
        Eigen::VectorXd share = model.masses.front().share;
        model.directional_masses = {model::added_mass(*model.body, model::free_faces(*model.body), 8.0),
                                    model::line_mass(share, {0.3, 1.0, -0.4}, 0.2)};
    }
    model::Model model;
    dynamics::SimulationOptions options;
};

class PassingMassGradient : public DirectionalMassGradient {
protected:
    /// One leaves within a step and between two others, the other one joins so.
    PassingMassGradient() {
        model.directional_masses[0].until_s = 0.0185;
        model.directional_masses[1].from_s = 0.0063;
    }
};

void expect_gradient(const model::Model& model, const dynamics::SimulationOptions& options) {
    const GradientCheck check = check_gradient(model, options, test::rough_loss(model),
                                               checked_parameters(model, options));
    ASSERT_TRUE(check.complete()) << check.message;
    int of_masses = 0;
    for (const GradientCheckRow& row : check.rows) {
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
        of_masses += row.name.starts_with("directional mass") ? 1 : 0;
    }
    EXPECT_EQ(of_masses, 2);
    test::record("median_error", check.median_error());
    test::record("worst_error", check.worst_error());
}

TEST_P(DirectionalMassGradient, OfAllParametersEqualsCentralDifferences) { expect_gradient(model, options); }
TEST_P(PassingMassGradient, OfAllParametersEqualsCentralDifferences) { expect_gradient(model, options); }

void expect_tangents(const model::Model& model, dynamics::SimulationOptions options) {
    options.solver.tangent_tolerance = 1e-12;
    const LossOfMotion loss = test::rough_loss(model);
    const material::YoungPoisson young = material::young_from_moduli(model.moduli.front());
    const double E = young.youngs_modulus_Pa, nu = young.poissons_ratio;
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-12;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    const SensitiveTrace tangents = simulate_with_tangents(model, options, {youngs_modulus_tangent(model, E)},
                                                           loss.nodes);
    ASSERT_TRUE(tangents.trace.complete());
    EXPECT_NEAR(test::along(loss.evaluate(run.motion), tangents.tangents[0]) /
                    young_gradient(model, run.gradient).youngs_modulus_Pa,
                1.0, 1e-7);

    const double step = 1e-4 * E;
    const auto moved = [&](double by) {
        model::Model other = model;
        other.moduli = model::uniform_moduli(model.body->cell_count(), E + by, nu);
        return dynamics::simulate(other, options);
    };
    const dynamics::Trace up = moved(step), down = moved(-step);
    const Eigen::Matrix3Xd x = (up.positions.back() - down.positions.back()) / (2.0 * step),
                           v = (up.velocities.back() - down.velocities.back()) / (2.0 * step);
    EXPECT_GT(x.norm(), 0.0);
    EXPECT_LT((tangents.tangents[0].positions.back() - x).norm(), 1e-5 * x.norm());
    EXPECT_LT((tangents.tangents[0].velocities.back() - v).norm(), 1e-5 * v.norm());
}

TEST_P(DirectionalMassGradient, TangentsOfTheModulusEqualDifferencesAndTheAdjoint) { expect_tangents(model, options); }
TEST_P(PassingMassGradient, TangentsOfTheModulusEqualDifferencesAndTheAdjoint) { expect_tangents(model, options); }

const auto mass_cases = testing::Values(
    MassCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight},
    MassCase{fem::ElementKind::hex8, dynamics::Integrator::bdf2, dynamics::StartKind::straight},
    MassCase{fem::ElementKind::hex8, dynamics::Integrator::trapezoidal, dynamics::StartKind::equilibrium},
    MassCase{fem::ElementKind::tet4, dynamics::Integrator::generalized_alpha, dynamics::StartKind::straight},
    MassCase{fem::ElementKind::tet10, dynamics::Integrator::implicit_euler, dynamics::StartKind::equilibrium});

std::string mass_case_name(const testing::TestParamInfo<MassCase>& c) {
    return to_string(c.param.kind) + "_" + to_string(c.param.scheme.integrator) +
           (c.param.start == dynamics::StartKind::equilibrium ? "_equilibrium" : "");
}
INSTANTIATE_TEST_SUITE_P(All, DirectionalMassGradient, mass_cases, mass_case_name);
INSTANTIATE_TEST_SUITE_P(All, PassingMassGradient, mass_cases, mass_case_name);

}  // namespace
}  // namespace myo::sensitivity
