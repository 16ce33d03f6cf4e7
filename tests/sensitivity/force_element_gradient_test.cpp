#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/contact.hpp"
#include "model/loaded_face.hpp"
#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"
#include "sensitivity/tangent_run.hpp"
#include "support/figures.hpp"
#include "support/tendon_body.hpp"

namespace myo::sensitivity {
namespace {

using test::blown_block;
using test::rough_loss;
using test::short_run;

struct ForceElementCase {
    fem::ElementKind kind;
    dynamics::TimeScheme scheme;
    dynamics::StartKind start;
};

/// Springs, drag and the pressure of a cavity, all at once.
class ForceElementGradient : public testing::TestWithParam<ForceElementCase> {};

TEST_P(ForceElementGradient, EqualsCentralDifferences) {
    const auto [kind, scheme, start] = GetParam();
    const model::Model model = blown_block(kind);
    dynamics::SimulationOptions options = short_run(scheme, start);
    options.initial.velocities = 0.3 * test::rough_field(model.body->node_count(), 0.4);
    const GradientCheck check = check_gradient(model, options, rough_loss(model), checked_parameters(model, options));
    ASSERT_TRUE(check.complete()) << check.message;
    int of_elements = 0;
    for (const GradientCheckRow& row : check.rows) {
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
        of_elements += row.name.starts_with("force element") ? 1 : 0;
    }
    EXPECT_EQ(of_elements, 7);
    EXPECT_LT(check.median_error(), 1e-6);
    test::record("median_error", check.median_error());
    test::record("worst_error", check.worst_error());
}

/// The gradient along each parameter of the force elements is that of the tangents.
void expect_tangents_equal_gradient(const model::Model& model, const dynamics::SimulationOptions& options,
                                    const LossOfMotion& loss) {
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-12;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    std::vector<ModelTangent> parameters;
    std::vector<double> expected;
    for (std::size_t e = 0; e < model.force_elements.size(); ++e)
        for (Eigen::Index k = 0; k < run.gradient.force_elements[e].size(); ++k) {
            ModelTangent one;
            one.force_elements.resize(model.force_elements.size());
            one.force_elements[e] = Eigen::VectorXd::Unit(run.gradient.force_elements[e].size(), k);
            parameters.push_back(std::move(one));
            expected.push_back(run.gradient.force_elements[e](k));
        }
    const SensitiveTrace tangents = simulate_with_tangents(model, options, parameters, loss.nodes);
    const MotionLoss derivative = loss.evaluate(run.motion);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        const double along = test::along(derivative, tangents.tangents[p]);
        EXPECT_NE(along, 0.0);
        EXPECT_NEAR(expected[p] / along, 1.0, 1e-7) << "parameter " << p;
    }
}

TEST_P(ForceElementGradient, EqualsTheTangents) {
    const auto [kind, scheme, start] = GetParam();
    const model::Model model = blown_block(kind);
    dynamics::SimulationOptions options = short_run(scheme, start);
    options.solver.tangent_tolerance = 1e-12;
    expect_tangents_equal_gradient(model, options, rough_loss(model));
}

INSTANTIATE_TEST_SUITE_P(
    All, ForceElementGradient,
    testing::Values(
        ForceElementCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight},
        ForceElementCase{fem::ElementKind::hex8, dynamics::Integrator::bdf2, dynamics::StartKind::straight},
        ForceElementCase{fem::ElementKind::hex8, dynamics::Integrator::trapezoidal, dynamics::StartKind::straight},
        ForceElementCase{fem::ElementKind::hex8, dynamics::Integrator::implicit_euler,
                         dynamics::StartKind::equilibrium},
        ForceElementCase{fem::ElementKind::tet4, dynamics::Integrator::generalized_alpha,
                         dynamics::StartKind::straight},
        ForceElementCase{fem::ElementKind::tet10, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight}),
    [](const auto& c) {
        return to_string(c.param.kind) + "_" + to_string(c.param.scheme.integrator) +
               (c.param.start == dynamics::StartKind::equilibrium ? "_equilibrium" : "");
    });

struct TendonCase {
    double friction;
    dynamics::StartKind start;
};

/// A block under a tendon whose tension is prescribed and one that takes in a length.
model::Model pulled_block(double friction) {
    model::Model model = test::hollow_block(fem::ElementKind::hex8);
    model.damping_s = 0.002;
    test::pull_by_tension({{-0.01, 0.004, 0.002}, {0.02, 0.004, 0.003}, {0.043, 0.005, 0.026}},
                          fibre::Signal{{0.0, 0.0125, 0.0125, 0.03}, {2.0, 4.0, 1.0, 3.0}}, model, friction);
    test::pull_by_shortening({{-0.01, 0.02, 0.026}, {0.03, 0.025, 0.027}, {0.058, 0.026, 0.02}},
                             fibre::Signal{{0.0, 0.03}, {1e-4, 2e-3}}, 900.0, model, friction);
    return model;
}

class TendonGradient : public testing::TestWithParam<TendonCase> {};

TEST_P(TendonGradient, EqualsCentralDifferencesAndTangents) {
    const auto [friction, start] = GetParam();
    const model::Model model = pulled_block(friction);
    dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2, start);
    options.solver.tangent_tolerance = 1e-12;
    const LossOfMotion loss = rough_loss(model);
    std::vector<CheckedParameter> checked;  // those of the tendons
    for (CheckedParameter& parameter : checked_parameters(model, options))
        if (parameter.name.starts_with("force element")) checked.push_back(std::move(parameter));
    EXPECT_EQ(checked.size(), 4u + 1u + 6u + 2u + 2u + 6u);  // knots, friction, guides; knots, two numbers, guides
    const GradientCheck check = check_gradient(model, options, loss, checked);
    ASSERT_TRUE(check.complete()) << check.message;
    for (const GradientCheckRow& row : check.rows)
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
    EXPECT_LT(check.median_error(), 1e-6);
    expect_tangents_equal_gradient(model, options, loss);
}

INSTANTIATE_TEST_SUITE_P(All, TendonGradient,
                         testing::Values(TendonCase{0.0, dynamics::StartKind::straight},
                                         TendonCase{0.4, dynamics::StartKind::equilibrium}),
                         [](const auto& c) { return c.param.friction > 0.0 ? "capstan" : "frictionless"; });

class ContactGradient : public testing::TestWithParam<dynamics::StartKind> {};

/// A block that slides on a rough ball, on which it lies under a slanted gravity: the friction changes with positions
/// and velocities, and has no potential. It is smooth enough (v0 = 0.5 m/s) for differences of initial velocities.
TEST_P(ContactGradient, EqualsCentralDifferencesAndTangents) {
    model::Model model = test::hollow_block(fem::ElementKind::hex8);
    model.damping_s = 0.002;
    model.gravity_m_s2 = {0.0, 4.0, -9.81};
    model.force_elements = {model::contact(*model.body, model::free_faces(*model.body),
                                           model::sphere_distance({0.06, 0.015, -0.039}, 0.04),
                                           {2e7, 2e-3, 0.4, 0.5, 1e-3})};
    dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2, GetParam());
    options.solver.tangent_tolerance = 1e-12;
    const LossOfMotion loss = rough_loss(model);
    const std::vector<CheckedParameter> checked = checked_parameters(model, options);
    EXPECT_TRUE(std::any_of(checked.begin(), checked.end(), [](const CheckedParameter& parameter) {
        return parameter.name.starts_with("force element") && parameter.name.find("friction") != std::string::npos;
    }));
    const GradientCheck check = check_gradient(model, options, loss, checked);
    ASSERT_TRUE(check.complete()) << check.message;
    for (const GradientCheckRow& row : check.rows)
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
    EXPECT_LT(check.median_error(), 1e-6);
    expect_tangents_equal_gradient(model, options, loss);
}

INSTANTIATE_TEST_SUITE_P(Starts, ContactGradient,
                         testing::Values(dynamics::StartKind::straight, dynamics::StartKind::equilibrium),
                         [](const auto& c) {
                             return c.param == dynamics::StartKind::straight ? "straight" : "equilibrium";
                         });

}  // namespace
}  // namespace myo::sensitivity
