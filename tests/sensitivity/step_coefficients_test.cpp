#include "sensitivity/step_coefficients.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <string>
#include <vector>

#include "dynamics/integrator.hpp"

namespace myo::sensitivity::step_coefficients_tests {
namespace {

using dynamics::Integrator;
using dynamics::TimeScheme;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::vector<TimeScheme> schemes{Integrator::tr_bdf2,
                                      Integrator::implicit_euler,
                                      Integrator::bdf2,
                                      Integrator::trapezoidal,
                                      TimeScheme(Integrator::generalized_alpha, 0.8),
                                      TimeScheme(Integrator::generalized_alpha, 0.0)};

/// A mass of 1 kg that starts with these nodal fields under a constant force, moved by the coefficients of its step.
VectorXd stepped(const StepCoefficients& c, const VectorXd& start, double force_N) {
    VectorXd fields = VectorXd::Zero(nodal_fields + c.stages());
    fields.head(nodal_fields) = start;
    for (int stage = 0; stage < c.stages(); ++stage) {
        // inertia x = constant + force; later stages and the end depend on the solution.
        const double constant = c.nodal.row(nodal_fields + stage).dot(fields);
        fields(nodal_fields + stage) = (constant + force_N) / c.inertia_1_s2[static_cast<std::size_t>(stage)];
    }
    return (c.nodal * fields).head(nodal_fields);
}
VectorXd fields_of(double x, double v, double v_lag, double force) {
    VectorXd fields = VectorXd::Zero(nodal_fields);
    fields(x_field) = x;
    fields(v_field) = v;
    fields(v_lag_field) = v_lag;
    fields(force_field) = force;
    return fields;
}

TEST(StepCoefficients, OfImplicitEulerAreThoseOfItsFormula) {
    const double h = 0.02, lambda = 3.0;
    const StepCoefficients c = step_coefficients(Integrator::implicit_euler, h, 0.01, lambda);
    ASSERT_EQ(c.stages(), 1);
    EXPECT_NEAR(c.inertia_1_s2[0], 2500.0, 1e-9);
    EXPECT_NEAR(c.rate_factor_1_s[0], 50.0, 1e-12);
    MatrixXd nodal = MatrixXd::Zero(6, 6), strain = MatrixXd::Zero(4, 4);
    nodal(x_field, 5) = 1.0;
    nodal(v_field, 5) = 50.0, nodal(v_field, x_field) = -50.0;
    nodal(force_field, 5) = 2500.0, nodal(force_field, x_field) = -2500.0, nodal(force_field, v_field) = -50.0;
    nodal(5, x_field) = 2500.0, nodal(5, v_field) = 50.0 + lambda;
    strain(strain_field, 3) = 1.0;
    strain(rate_field, 3) = 50.0, strain(rate_field, strain_field) = -50.0;
    strain(3, strain_field) = -50.0;
    EXPECT_LT((c.nodal - nodal).norm(), 1e-10);
    EXPECT_LT((c.strain - strain).norm(), 1e-11);
}

/// A body without forces flies straight on with any scheme; its places add up, and nothing else changes.
TEST(StepCoefficients, LetAFreeBodyFlyStraightOn) {
    const double h = 0.02;
    for (const TimeScheme& scheme : schemes)
        for (const double before : {0.0, 0.02, 0.013}) {
            const StepCoefficients c = step_coefficients(scheme, h, before, 0.0);
            const VectorXd end = stepped(c, fields_of(3.0, -2.0, 0.0, 0.0), 0.0);
            const std::string what = to_string(scheme.integrator) + " after " + std::to_string(before);
            EXPECT_NEAR(end(x_field), 3.0 - 2.0 * h, 1e-12) << what;
            EXPECT_NEAR(end(v_field), -2.0, 1e-10) << what;
            EXPECT_NEAR(end(v_lag_field), 0.0, 1e-10) << what;
            EXPECT_NEAR(end(force_field), 0.0, 1e-7) << what;
        }
}

/// Under a constant force schemes of second order are exact, and implicit Euler falls by twice the way.
TEST(StepCoefficients, LetABodyFallAsTheSchemeSays) {
    const double h = 0.02, a = 9.0, v = 0.5;
    struct Case {
        TimeScheme scheme;
        double before, v_lag, way_m;
    };
    const double exact = v * h + 0.5 * a * h * h;
    for (const Case& c : {Case{Integrator::tr_bdf2, 0.02, 0.0, exact},
                          {Integrator::trapezoidal, 0.02, 0.0, exact},
                          {Integrator::bdf2, 0.0, 0.0, exact},
                          {Integrator::bdf2, 0.008, -0.004 * a, exact},
                          {Integrator::implicit_euler, 0.02, 0.0, v * h + a * h * h}}) {
        const VectorXd end = stepped(step_coefficients(c.scheme, h, c.before, 0.0), fields_of(1.0, v, c.v_lag, a), a);
        EXPECT_NEAR(end(x_field), 1.0 + c.way_m, 1e-12) << to_string(c.scheme.integrator);
        EXPECT_NEAR(end(v_field), v + a * h, 1e-10) << to_string(c.scheme.integrator);
        EXPECT_NEAR(end(force_field), a, 1e-8) << to_string(c.scheme.integrator);
    }
}

/// Strains go with positions: what is nodal of x and v holds for strains and their rates.
TEST(StepCoefficients, TreatStrainsAsPositions) {
    for (const TimeScheme& scheme : schemes) {
        const StepCoefficients c = step_coefficients(scheme, 0.02, 0.013, 4.0);
        ASSERT_EQ(c.strain.rows(), strain_fields + c.stages());
        for (int row = 0; row < strain_fields; ++row)
            for (int column = 0; column < c.strain.cols(); ++column) {
                const int beside = column < strain_fields ? column : column - strain_fields + nodal_fields;
                EXPECT_NEAR(c.strain(row, column), c.nodal(row, beside), 1e-9) << to_string(scheme.integrator);
            }
        for (const double rate : c.rate_factor_1_s) EXPECT_GT(rate, 0.0);
    }
}

TEST(StepCoefficients, ChangeWithTheVelocityForceAsTheirDifferences) {
    const double h = 0.02, before = 0.013, lambda = 4.0, d = 0.5;
    for (const TimeScheme& scheme : schemes) {
        const StepCoefficients by = step_coefficients_by_velocity_force(scheme, h, before, lambda),
                               up = step_coefficients(scheme, h, before, lambda + d),
                               down = step_coefficients(scheme, h, before, lambda - d);
        const MatrixXd nodal = (up.nodal - down.nodal) / (2.0 * d);
        EXPECT_GT(nodal.norm(), 0.0);
        EXPECT_LT((by.nodal - nodal).norm(), 1e-8 * nodal.norm()) << to_string(scheme.integrator);
        EXPECT_EQ(by.strain.norm(), 0.0) << "strains do not feel it";
        for (std::size_t k = 0; k < by.inertia_1_s2.size(); ++k) {
            EXPECT_NEAR(by.inertia_1_s2[k], (up.inertia_1_s2[k] - down.inertia_1_s2[k]) / (2.0 * d), 1e-8);
            EXPECT_EQ(by.rate_factor_1_s[k], 0.0);
        }
    }
    // A free mass is driven on: with implicit Euler by Lambda h in a step.
    const VectorXd end = stepped(step_coefficients(Integrator::implicit_euler, h, h, lambda),
                                 fields_of(0.0, 1.0, 0.0, 0.0), 0.0);
    EXPECT_NEAR(end(v_field), 1.0 + lambda * h, 1e-12);
}

TEST(StepCoefficients, KnowRowsOfMomentumAndColumnsOfMotion) {
    const std::vector<bool> momentum{false, false, false, true, true, true, true},
        motion{true, true, true, false, false, true, true};
    for (int k = 0; k < 7; ++k) {
        EXPECT_EQ(is_momentum_row(k), momentum[static_cast<std::size_t>(k)]) << k;
        EXPECT_EQ(is_motion_column(k), motion[static_cast<std::size_t>(k)]) << k;
    }
}

}  // namespace
}  // namespace myo::sensitivity::step_coefficients_tests
