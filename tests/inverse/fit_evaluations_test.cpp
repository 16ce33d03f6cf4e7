#include "inverse/fit_evaluations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "inverse/bounded_step.hpp"
#include "inverse/marginal_nuisance.hpp"
#include "inverse/reused_jacobian.hpp"
#include "support/not_finite.hpp"

namespace myo::inverse::fit_evaluations_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::infinity;

const Parameter linear{.name = "E", .value = 2.6e5, .lower = 1e5, .upper = 1e6, .scale = 5e4};
const Parameter decades{
    .name = "drag", .value = 0.3, .lower = 0.0, .upper = 100.0, .scale = 1e-3, .over_decades = true};

TEST(InternalValues, AreInTheScaleAndReturnExactly) {
    EXPECT_DOUBLE_EQ(internal_value(linear, 1e5), 2.0);
    EXPECT_EQ(internal_value(decades, 0.0), 0.0);
    // From far below the scale the values are proportional, from far above each unit is a factor of e.
    EXPECT_NEAR(internal_value(decades, 1e-9), 1e-6, 1e-11);
    EXPECT_NEAR(internal_value(decades, 50.0) - internal_value(decades, 50.0 / std::exp(1.0)), 1.0, 1e-4);
    for (const Parameter& p : {linear, decades}) {
        // To the last bit at the value that a person declared.
        EXPECT_EQ(physical_value(p, internal_value(p, p.value)), p.value);
        for (const double value : {0.0, 0.7 * p.value, 30.0 * p.value}) {
            const double u = internal_value(p, value), h = 1e-5;
            EXPECT_NEAR(physical_value(p, u), value, 1e-12 * p.value);
            EXPECT_NEAR(physical_slope(p, u) * 2.0 * h / (physical_value(p, u + h) - physical_value(p, u - h)), 1.0,
                        1e-6);
        }
    }
    const VectorXd both = physical_values({linear, decades}, Eigen::Vector2d(3.0, 0.0));
    EXPECT_EQ(both, Eigen::Vector2d(1.5e5, 0.0));
    EXPECT_EQ(physical_slopes({linear, decades}, Eigen::Vector2d(3.0, 0.0)), Eigen::Vector2d(5e4, 1e-3));
}

TEST(InternalBounds, LeaveRoomToTheBoundsAndAFactorOverDecades) {
    Parameter free = linear;
    free.lower = -infinity, free.upper = infinity;
    const std::vector<Parameter> parameters = {linear, free, decades, decades, linear};
    VectorXd here(5);
    // The third is near its lower bound, the fourth far from both, the last has been rounded beyond its upper one.
    here << 5.0, 5.0, internal_value(decades, 1e-3), internal_value(decades, 1.0), 20.0 + 1e-9;
    const StepBounds bounds = internal_step_bounds(parameters, here);
    EXPECT_NEAR(bounds.lower(0), -3.0, 1e-12);
    EXPECT_NEAR(bounds.upper(0), 15.0, 1e-12);
    EXPECT_EQ(bounds.lower(1), -infinity);
    EXPECT_EQ(bounds.upper(1), infinity);
    EXPECT_NEAR(bounds.lower(2), -std::log(2.0), 1e-12);
    EXPECT_EQ(bounds.upper(2), 2.0) << "e squared at once";
    EXPECT_EQ(bounds.lower(3), -2.0);
    EXPECT_EQ(bounds.upper(3), 2.0);
    EXPECT_EQ(bounds.upper(4), 0.0) << "staying is always allowed";
    EXPECT_NEAR(bounds.lower(4), -18.0, 1e-6);
}

/// A model with one parameter and the residuals (value, 1), which counts its runs; not to be run above 100, and without
/// a finite result at 50.
struct Counted {
    int runs = 0;
    std::atomic<bool> cancel{false};
    LeastSquaresReport report;
    LeastSquaresOptions options;
    Progress progress{{}, &cancel};
    ResidualFunction function = [this](const VectorXd& p, const Progress&) {
        ++runs;
        ResidualEvaluation made{p(0) <= 100.0, p(0) <= 100.0 ? "" : "too far", Eigen::Vector2d(p(0), 1.0), {}};
        if (p(0) == 50.0) made.residuals(1) = 1e200;
        return made;
    };
    FitEvaluations evaluations{function, options, progress, report};
    const ResidualEvaluation& at(double value) { return evaluations.at(VectorXd::Constant(1, value)); }
};

TEST(Evaluations, AreMadeOncePerPoint) {
    Counted counted;
    for (const double value : {3.0, 4.0, 3.0, 5.0, 4.0, 3.0}) EXPECT_EQ(counted.at(value).residuals(0), value);
    EXPECT_EQ(counted.runs, 3);
    EXPECT_EQ(counted.report.evaluations, 3);
    ASSERT_EQ(counted.report.history.size(), 3u);
    // The oldest of four points is forgotten.
    counted.at(6.0);
    counted.at(3.0);
    EXPECT_EQ(counted.runs, 5);
    EXPECT_EQ(counted.report.history.back().values(0), 3.0);
}

TEST(Evaluations, KeepTheBestAndTheFirstThatCouldBeRun) {
    Counted counted;
    EXPECT_FALSE(counted.at(200.0).ok);
    EXPECT_EQ(counted.at(200.0).message, "too far");
    EXPECT_FALSE(counted.report.usable());
    EXPECT_EQ(counted.report.history[0].cost, infinity);
    counted.at(4.0);
    EXPECT_DOUBLE_EQ(counted.report.cost_before, 8.5) << "half the sum of squares";
    EXPECT_DOUBLE_EQ(counted.report.cost_after, 8.5);
    counted.at(2.0);
    counted.at(-2.0);
    counted.at(7.0);
    EXPECT_DOUBLE_EQ(counted.report.cost_before, 8.5);
    EXPECT_DOUBLE_EQ(counted.report.cost_after, 2.5);
    EXPECT_EQ(counted.report.values(0), 2.0) << "the first of equals";
    EXPECT_EQ(counted.evaluations.best().residuals(0), 2.0);
    EXPECT_EQ(counted.report.evaluations, 5);
}

TEST(Evaluations, WithoutAFiniteSumOrAfterACancelAreNotOk) {
    Counted counted;
    EXPECT_FALSE(counted.at(50.0).ok);
    EXPECT_EQ(counted.at(50.0).message, "the sum of squared differences to the data is not a finite number");
    EXPECT_FALSE(counted.report.history[0].ok());
    counted.at(1.0);
    counted.cancel = true;
    EXPECT_EQ(counted.at(2.0).message, "stopped by the user");
    EXPECT_EQ(counted.runs, 2) << "nothing more is run";
    EXPECT_EQ(counted.report.evaluations, 2);
    EXPECT_TRUE(counted.at(1.0).ok) << "what is known stays so";
}

TEST(Covariance, IsThatOfTheNoiseUnlessTheResidualsAreLarger) {
    // One parameter with four residuals of derivative 1: the variance is that of a mean.
    const std::vector<Parameter> one = {{.name = "x"}};
    const MatrixXd J = MatrixXd::Ones(4, 1);
    LeastSquaresReport report;
    for (const double residual : {0.1, 1.0, 3.0}) {
        set_covariance(one, {true, {}, VectorXd::Constant(4, residual), J}, report);
        // |r|^2 over the three degrees of freedom that are left.
        EXPECT_NEAR(report.deviations(0), std::sqrt(std::max(1.0, 4.0 * residual * residual / 3.0) / 4.0), 1e-12);
    }
    // As many residuals as parameters leave one degree of freedom, not none.
    set_covariance(one, {true, {}, VectorXd::Constant(1, 3.0), MatrixXd::Ones(1, 1)}, report);
    EXPECT_NEAR(report.deviations(0), 3.0, 1e-12);
    set_covariance(one, {true, {}, VectorXd::Ones(4), MatrixXd::Zero(4, 1)}, report);
    EXPECT_TRUE(std::isnan(report.deviations(0)));
    EXPECT_EQ(report.undetermined.size(), 1u);
    set_covariance(one, {}, report);
    EXPECT_TRUE(std::isnan(report.deviations(0)));
    EXPECT_TRUE(report.undetermined.empty()) << "nothing is known of an end that could not be run";
    set_covariance({}, {true, {}, VectorXd::Ones(4), {}}, report);
    EXPECT_EQ(report.deviations.size(), 0);
}

/// Jacobians of the residual c ln(1 + value / scale), which is linear in the internal value.
TEST(ReusedJacobians, AreThoseOfTheInternalValues) {
    const std::vector<Parameter> parameters = {decades};
    int asked = 0;
    const auto residual = [](double value) { return VectorXd::Constant(1, 7.0 * std::log1p(value / 1e-3)); };
    const JacobianFunction function = [&](const VectorXd& p, const ResidualEvaluation&, const Progress&) {
        ++asked;
        return MatrixXd::Constant(1, 1, 7.0 / (1e-3 + p(0)));
    };
    LeastSquaresReport report;
    const LeastSquaresOptions options;
    const Progress progress;
    ReusedJacobian reused(parameters, function, options, progress, report);
    for (const double value : {0.3, 0.01, 20.0}) {
        const MatrixXd J = reused.at(VectorXd::Constant(1, value), {true, {}, residual(value), {}});
        ASSERT_EQ(J.size(), 1);
        EXPECT_NEAR(J(0, 0) * (1e-3 + value), 7.0, 1e-9) << value;
    }
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(report.jacobians, 1);
    // Residuals that it does not foretell within 2 % ask for another one.
    const double change = residual(5.0)(0) - residual(0.3)(0);
    for (const double error : {0.019, 0.021}) {
        const VectorXd seen = VectorXd::Constant(1, residual(0.3)(0) + change / (1.0 - error));
        reused.at(VectorXd::Constant(1, 5.0), {true, {}, seen, {}});
        EXPECT_EQ(asked, error < 0.02 ? 1 : 2) << error;
    }
}

TEST(ReusedJacobians, AreEmptyWhereTheModelHasNone) {
    const std::vector<Parameter> parameters = {linear};
    MatrixXd given = MatrixXd::Constant(1, 1, test::nan);
    const JacobianFunction function = [&](const VectorXd&, const ResidualEvaluation&, const Progress&) {
        return given;
    };
    LeastSquaresReport report;
    const LeastSquaresOptions options;
    std::atomic<bool> cancel{false};
    const Progress progress({}, &cancel);
    ReusedJacobian reused(parameters, function, options, progress, report);
    const VectorXd here = VectorXd::Constant(1, 3e5);
    const ResidualEvaluation there{true, {}, VectorXd::Ones(1), {}};
    EXPECT_EQ(reused.at(here, there).size(), 0) << "not a number";
    given = MatrixXd::Ones(2, 1);
    EXPECT_EQ(reused.at(here, there).size(), 0) << "of other residuals";
    EXPECT_EQ(report.jacobians, 0);
    given = MatrixXd::Constant(1, 1, 4.0);
    EXPECT_DOUBLE_EQ(reused.at(here, there)(0, 0), 4.0);
    // After a cancel the last one is good enough, whatever the residuals say.
    cancel = true;
    given(0, 0) = 9.0;
    EXPECT_DOUBLE_EQ(reused.at(2.0 * here, {true, {}, VectorXd::Constant(1, 1e6), {}})(0, 0), 4.0);
    // Evaluations that bring their own are taken at their word.
    EXPECT_EQ(reused.at(here, {true, {}, VectorXd::Ones(1), MatrixXd::Constant(1, 1, 5.0)})(0, 0), 5.0);
}

TEST(BoundedSteps, OfOneUnknownAreClipped) {
    const MatrixXd A = Eigen::Vector2d(3.0, 4.0);
    const Eigen::Vector2d r(-3.0, -4.0);  // the free minimum is 1
    const auto step = [&](double low, double high) {
        return bounded_step(A, r, VectorXd::Constant(1, low), VectorXd::Constant(1, high))(0);
    };
    EXPECT_NEAR(step(-infinity, infinity), 1.0, 1e-12);
    EXPECT_EQ(step(-infinity, 0.5), 0.5);
    EXPECT_EQ(step(0.0, 0.0), 0.0);
    EXPECT_EQ(bounded_step(-A, r, VectorXd::Constant(1, -0.25), VectorXd::Constant(1, 0.5))(0), -0.25);
    EXPECT_EQ(bounded_step(MatrixXd(2, 0), r, {}, {}).size(), 0);
    EXPECT_EQ(bounded_step(A, Eigen::Vector2d::Zero(), VectorXd::Constant(1, -1.0), VectorXd::Ones(1))(0), 0.0);
}

TEST(Nuisances, OfOneUnknownHaveTheirClosedForms) {
    for (const double a : {1e-8, 0.5, 3.0, 1e4}) {
        const MarginalNuisance nuisance(MatrixXd::Constant(1, 1, a));
        const double root = std::sqrt(1.0 + a * a), r = 2.0, j = 5.0;
        const VectorXd white = nuisance.whitened(VectorXd::Constant(1, r));
        EXPECT_NEAR(white(0) * root / r, 1.0, 1e-9) << a;
        EXPECT_NEAR(nuisance.mean(white)(0) * (1.0 + a * a) / (-a * r), 1.0, 1e-9) << a;
        const MatrixXd C = nuisance.covariance(nuisance.whitened(VectorXd::Constant(1, j)),
                                               MatrixXd::Constant(1, 1, 0.3));
        const double b = a * j / (1.0 + a * a);
        EXPECT_NEAR(C(0, 0) / (1.0 / (1.0 + a * a) + 0.3 * b * b), 1.0, 1e-9) << a;
    }
}

}  // namespace
}  // namespace myo::inverse::fit_evaluations_test
