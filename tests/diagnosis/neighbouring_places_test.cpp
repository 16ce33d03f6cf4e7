#include "diagnosis/verdict/neighbouring_places.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "diagnosis/made_problem.hpp"

namespace myo::diagnosis::neighbouring_places_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double cell_m = 0.01;
const Vector3d start_m(0.05, 0.01, 0.03);

prediction::ModelParameter number_of_effect(const std::string& key, int component, double lower, double upper,
                                            double scale) {
    prediction::ModelParameter p;
    p.kind = prediction::ModelParameter::Kind::effect;
    p.of_effect = key;
    p.component = component;
    p.parameter = {key, 0.0, lower, upper, scale};
    return p;
}

/// Fit of the modulus, the force and the place of dry friction. The columns of its Jacobian are multiples of unit
/// vectors; the force can make up for a move along x but for `left` [1/m].
JointFit fit_of_friction(double left, double along_y) {
    JointFit fit = test::made_fit(VectorXd::Zero(8), VectorXd::Unit(8, 0));
    fit.parameters.push_back(number_of_effect("friction_force_N", -1, 0.0, 100.0, 0.005));
    const Vector3d lowest(0.0, 0.0, 0.0), highest(0.1, 0.03, 0.03);
    for (int k = 0; k < 3; ++k)
        fit.parameters.push_back(number_of_effect("position_m", k, lowest(k), highest(k), 0.01));
    fit.values.effects = {{"dry_friction", {{"friction_force_N", 0.02}, {"position_m", VectorXd(start_m)}}}};
    fit.effects = fit.values.effects;
    MatrixXd J = MatrixXd::Zero(8, 5);
    J.col(0) = fit.jacobian;
    J(1, 1) = 2000.0;  // 20 noise levels per 0.01 N
    J(1, 2) = 500.0;   // as many as the force by 0.25 N/m
    J(2, 2) = left;
    J(3, 3) = along_y;  // z lies across the surface and changes nothing
    fit.jacobian = J;
    return fit;
}

Vector3d position(const prediction::ParameterValues& values) {
    return std::get<VectorXd>(values.effects.front().parameters.at("position_m"));
}

double force_N(const prediction::ParameterValues& values) {
    return std::get<double>(values.effects.front().parameters.at("friction_force_N"));
}

TEST(NeighbouringPlaces, LieACellFurtherWhereTheDataHardlyDetermineThem) {
    // Three deviations per cell along x, 30 along y.
    const auto starts = neighbouring_places(fit_of_friction(300.0, 3000.0), cell_m, {});
    ASSERT_EQ(starts.size(), 2u);
    const double sense = position(starts[0]).x() > start_m.x() ? 1.0 : -1.0;
    for (std::size_t k = 0; k < 2; ++k) {
        const double dx = (k == 0 ? sense : -sense) * cell_m;
        EXPECT_NEAR((position(starts[k]) - start_m - Vector3d(dx, 0.0, 0.0)).norm(), 0.0, 1e-12);
        EXPECT_NEAR(force_N(starts[k]), 0.02 - 0.25 * dx, 1e-12) << "the force makes up for the move";
        EXPECT_NEAR(starts[k].youngs_modulus_Pa, test::made_modulus_Pa, 1e-6) << "it has no part in it";
    }
}

TEST(NeighbouringPlaces, AreSoughtBetweenTheLimitsOfDeviations) {
    const PlacePolicy policy;
    struct Case {
        double deviations;  // per cell, along x
        std::size_t starts;
    };
    for (const Case& c : {Case{0.99 * policy.min_deviations, 0},
                          {1.01 * policy.min_deviations, 2},
                          {0.99 * policy.max_deviations, 2},
                          {1.01 * policy.max_deviations, 0}})
        EXPECT_EQ(neighbouring_places(fit_of_friction(c.deviations / cell_m, 1e4), cell_m, policy).size(), c.starts)
            << c.deviations;
}

TEST(NeighbouringPlaces, StayInTheBoundsAndLeaveOutWhatTheyHold) {
    JointFit fit = fit_of_friction(300.0, 1e4);
    // 4 mm, less than half a cell, are left towards larger x.
    fit.values.effects.front().parameters["position_m"] = VectorXd(Vector3d(0.096, 0.01, 0.03));
    const auto starts = neighbouring_places(fit, cell_m, {});
    ASSERT_EQ(starts.size(), 1u);
    EXPECT_NEAR(position(starts[0]).x(), 0.086, 1e-12);
    // A force cannot become negative.
    fit.values.effects.front().parameters["friction_force_N"] = 1e-3;
    fit.values.effects.front().parameters["position_m"] = VectorXd(start_m);
    for (const auto& start : neighbouring_places(fit, cell_m, {})) EXPECT_GE(force_N(start), 0.0);
}

TEST(NeighbouringPlaces, NeedAPlaceAndItsDerivatives) {
    JointFit fit = fit_of_friction(300.0, 1e4);
    fit.jacobian.resize(8, 0);
    EXPECT_TRUE(neighbouring_places(fit, cell_m, {}).empty());
    EXPECT_TRUE(neighbouring_places(test::made_fit(VectorXd::Zero(8), VectorXd::Unit(8, 0)), cell_m, {}).empty());
}

}  // namespace
}  // namespace myo::diagnosis::neighbouring_places_test
