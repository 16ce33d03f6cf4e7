#include "inverse/least_squares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

namespace myo::inverse {
namespace {

/// y = amplitude exp(-rate t), unit noise.
struct Decay {
    Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(200, 0.0, 5.0);
    Eigen::VectorXd y;

    ResidualEvaluation operator()(const Eigen::VectorXd& p, const Progress& = {}) const {
        ResidualEvaluation e;
        const Eigen::ArrayXd shape = (-p(1) * t.array()).exp();
        e.residuals = p(0) * shape.matrix() - y;
        e.jacobian.resize(t.size(), 2);
        e.jacobian.col(0) = shape;
        e.jacobian.col(1) = -p(0) * t.array() * shape;
        e.ok = true;
        return e;
    }
};

Decay decay_data(unsigned seed) {
    Decay decay;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise;
    decay.y = 50.0 * (-0.8 * decay.t.array()).exp();
    for (double& y : decay.y) y += noise(random);
    return decay;
}

const std::vector<Parameter> start = {{"amplitude", 20.0, 0.0, 1e3, 10.0}, {"rate_1_s", 2.0, 0.0, 10.0, 1.0}};

TEST(LeastSquares, CoversTheTruthAsOftenAsItsDeviationsPromise) {
    int within = 0;
    constexpr int seeds = 200;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const Decay decay = decay_data(seed);
        const LeastSquaresReport report = fit_least_squares(start, decay);
        ASSERT_TRUE(report.converged()) << report.message;
        if (std::abs(report.values(1) - 0.8) < report.deviations(1)) ++within;
    }
    // 68.3 % of 200 is 137 with a standard deviation of 6.6.
    EXPECT_NEAR(within, 137, 20);
}

TEST(LeastSquares, RunsTheModelOncePerPoint) {
    const Decay decay = decay_data(3);
    int calls = 0;
    const LeastSquaresReport report = fit_least_squares(start, [&](const Eigen::VectorXd& p, const Progress&) {
        ++calls;
        return decay(p);
    });
    EXPECT_EQ(report.evaluations, calls);
    EXPECT_LE(calls, 12);
    EXPECT_LT(report.cost_after, report.cost_before);
}

/// A model rounds: near the end a step may lose as little as it would have gained. That is the end; shorter ones would
/// not be better.
TEST(LeastSquares, EndsWhereAStepLosesNoMoreThanTheModelRounds) {
    const Decay decay = decay_data(3);
    const LeastSquaresReport smooth = fit_least_squares(start, decay);
    std::vector<Parameter> near = start;
    for (std::size_t i = 0; i < near.size(); ++i)
        near[i].value = smooth.values(static_cast<Eigen::Index>(i)) +
                        0.001 * smooth.deviations(static_cast<Eigen::Index>(i));
    const LeastSquaresReport report = fit_least_squares(near, [&](const Eigen::VectorXd& p, const Progress&) {
        ResidualEvaluation e = decay(p);
        const Eigen::Index m = e.residuals.size();
        e.residuals.conservativeResize(m + 1);
        e.residuals(m) = p(1) == near[1].value ? 0.0 : 0.01;
        e.jacobian.conservativeResize(m + 1, Eigen::NoChange);
        e.jacobian.row(m).setZero();
        return e;
    });
    EXPECT_LT(0.5 * 0.01 * 0.01, LeastSquaresOptions{}.relative_decrease * smooth.cost_after);
    EXPECT_TRUE(report.converged()) << report.message;
    EXPECT_LE(report.evaluations, 3);
    EXPECT_EQ(report.values(1), near[1].value);
}

/// Where Jacobians are asked for apart, a fit makes few, ends where one ends that has them at every point, and knows
/// the Jacobian there: all within this distance.
template <class Fit>
void expect_few_jacobians(const Fit& fit, double near, double max_share) {
    int asked = 0, points = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Decay decay = decay_data(seed);
        const LeastSquaresReport all = fit_least_squares(start, decay);
        int jacobians = 0;
        const ResidualFunction residuals = [&](const Eigen::VectorXd& p, const Progress&) {
            return ResidualEvaluation{true, {}, decay(p).residuals, {}};
        };
        const JacobianFunction jacobian = [&](const Eigen::VectorXd& p, const ResidualEvaluation& there,
                                              const Progress&) {
            ++jacobians;
            EXPECT_EQ(there.residuals, decay(p).residuals);
            return decay(p).jacobian;
        };
        const LeastSquaresReport report = fit(residuals, jacobian);
        ASSERT_TRUE(report.converged()) << report.message;
        EXPECT_EQ(report.jacobians, jacobians);
        asked += jacobians;
        points += all.evaluations;
        EXPECT_LT((report.values - all.values).cwiseQuotient(all.deviations).norm(), near);
        EXPECT_LT((report.deviations - all.deviations).cwiseQuotient(all.deviations).norm(), 2.5 * near);
        EXPECT_LT((report.jacobian - decay(report.values).jacobian).norm(), 2.5 * near * report.jacobian.norm());
    }
    EXPECT_LT(asked, max_share * points);
}

TEST(LeastSquares, UsesAJacobianAsLongAsItForetellsTheResiduals) {
    expect_few_jacobians(
        [](const ResidualFunction& residuals, const JacobianFunction& jacobian) {
            return fit_least_squares(start, residuals, jacobian, {}, {});
        },
        0.07, 0.8);
}

TEST(LeastSquares, AsksForFewDearJacobians) {
    expect_few_jacobians(
        [](const ResidualFunction& residuals, const JacobianFunction& jacobian) {
            return fit_by_secants(start, residuals, jacobian, {}, {});
        },
        0.02, 0.7);
}

TEST(LeastSquares, FailsWhereTheModelCannotBeRunBesideTheStart) {
    const Decay decay = decay_data(3);
    const auto residuals = [&](const Eigen::VectorXd& p, const Progress&) {
        return ResidualEvaluation{true, {}, decay(p).residuals, {}};
    };
    const auto none = [](const Eigen::VectorXd&, const ResidualEvaluation&, const Progress&) {
        return Eigen::MatrixXd();
    };
    const LeastSquaresReport report = fit_least_squares(start, residuals, none, {}, {});
    EXPECT_EQ(report.status, FitStatus::failed);
    EXPECT_EQ(report.message, "the model could not be run near these values");
}

/// With the Jacobian of the start given, no other is asked for there while it serves.
TEST(LeastSquares, AGoodGuessOfTheJacobianSavesAskingForIt) {
    const Decay decay = decay_data(2);
    const std::vector<Parameter> near = {{"amplitude", 45.0, 0.0, 1e3, 10.0}, {"rate_1_s", 0.9, 0.0, 10.0, 1.0}};
    LeastSquaresOptions options;
    std::vector<Eigen::VectorXd> asked;
    const auto fit = [&] {
        asked.clear();
        return fit_by_secants(
            near,
            [&](const Eigen::VectorXd& p, const Progress&) {
                return ResidualEvaluation{true, {}, decay(p).residuals, {}};
            },
            [&](const Eigen::VectorXd& p, const ResidualEvaluation&, const Progress&) {
                asked.push_back(p);
                return decay(p).jacobian;
            },
            options, {});
    };
    const LeastSquaresReport plain = fit();
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.front(), plain.start);
    options.jacobian_guess = decay(plain.start).jacobian;
    const LeastSquaresReport informed = fit();
    ASSERT_TRUE(informed.converged());
    for (const Eigen::VectorXd& p : asked) EXPECT_NE(p, plain.start);
    EXPECT_LT(informed.jacobians, plain.jacobians);
}

/// With no Jacobian allowed beside the guess, secants find nearly as good an end.
TEST(LeastSquares, SecantsHaveToDoWhereNoJacobianIsAllowed) {
    const Decay decay = decay_data(2);
    const std::vector<Parameter> near = {{"amplitude", 35.0, 0.0, 1e3, 10.0}, {"rate_1_s", 1.2, 0.0, 10.0, 1.0}};
    LeastSquaresOptions options;
    options.jacobian_guess = decay(Eigen::Vector2d(45.0, 0.9)).jacobian;
    options.max_jacobians = 0;
    const LeastSquaresReport report = fit_by_secants(
        near,
        [&](const Eigen::VectorXd& p, const Progress&) {
            return ResidualEvaluation{true, {}, decay(p).residuals, {}};
        },
        [&](const Eigen::VectorXd& p, const ResidualEvaluation&, const Progress&) {
            ADD_FAILURE() << "asked for";
            return decay(p).jacobian;
        },
        options, {});
    ASSERT_TRUE(report.converged()) << report.message;
    const LeastSquaresReport all = fit_least_squares(near, decay);
    EXPECT_LT(((report.values - all.values).cwiseQuotient(all.deviations)).norm(), 0.5);
}

/// A guess that points the wrong way costs a step, not the fit.
TEST(LeastSquares, RecoversFromABadGuessOfTheJacobian) {
    const Decay decay = decay_data(2);
    const LeastSquaresReport all = fit_least_squares(start, decay);
    LeastSquaresOptions options;
    options.jacobian_guess = -decay(all.start).jacobian;
    const LeastSquaresReport report = fit_by_secants(
        start,
        [&](const Eigen::VectorXd& p, const Progress&) {
            return ResidualEvaluation{true, {}, decay(p).residuals, {}};
        },
        [&](const Eigen::VectorXd& p, const ResidualEvaluation&, const Progress&) { return decay(p).jacobian; },
        options, {});
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_LT(((report.values - all.values).cwiseQuotient(all.deviations)).norm(), 0.02);
}

/// Nothing to fit is judged all the same, and fewer data than numbers are fitted.
TEST(LeastSquares, SecantsTakeNoNumbersAndFewData) {
    const auto line = [](const Eigen::VectorXd& p) {
        return Eigen::VectorXd::Constant(1, p.size() > 0 ? 3.0 * p(0) + 4.0 * p(1) - 10.0 : 2.0);
    };
    const auto fit = [&](const std::vector<Parameter>& parameters) {
        return fit_by_secants(
            parameters,
            [&](const Eigen::VectorXd& p, const Progress&) {
                return ResidualEvaluation{true, {}, line(p), {}};
            },
            [&](const Eigen::VectorXd& p, const ResidualEvaluation&, const Progress&) {
                return p.size() > 0 ? Eigen::MatrixXd(Eigen::RowVector2d(3.0, 4.0)) : Eigen::MatrixXd(1, 0);
            },
            {}, {});
    };
    const LeastSquaresReport none = fit({});
    EXPECT_TRUE(none.converged()) << none.message;
    EXPECT_EQ(none.jacobian.rows(), 1);
    EXPECT_NEAR(none.cost_after, 2.0, 1e-15);
    const LeastSquaresReport few = fit({{"a", 1.0}, {"b", 0.0}});
    EXPECT_TRUE(few.converged()) << few.message;
    EXPECT_NEAR(few.cost_after, 0.0, 1e-12);
}

/// Steps end at the bounds, also where the fit has to go along one to its end.
TEST(LeastSquares, SecantsStayWithinBounds) {
    const Decay decay = decay_data(4);
    std::vector<Parameter> bounded = start;
    bounded[1].lower = 1.0;
    const LeastSquaresReport report = fit_by_secants(
        bounded,
        [&](const Eigen::VectorXd& p, const Progress&) {
            EXPECT_GE(p(1), 1.0 - 1e-12);
            return ResidualEvaluation{true, {}, decay(p).residuals, {}};
        },
        [&](const Eigen::VectorXd& p, const ResidualEvaluation&, const Progress&) { return decay(p).jacobian; }, {},
        {});
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values(1), 1.0, 1e-9);
    const Eigen::VectorXd shape = (-decay.t.array()).exp();
    EXPECT_NEAR(report.values(0), decay.y.dot(shape) / shape.squaredNorm(), 0.02 * report.deviations(0));
}

TEST(LeastSquares, StaysWithinBounds) {
    const Decay decay = decay_data(4);
    std::vector<Parameter> bounded = start;
    bounded[1].lower = 1.0;
    const LeastSquaresReport report = fit_least_squares(bounded, decay);
    EXPECT_NEAR(report.values(1), 1.0, 1e-6);
}

TEST(LeastSquares, StepsBackWhereTheModelCannotBeRun) {
    const Decay decay = decay_data(5);
    const LeastSquaresReport report = fit_least_squares(start, [&](const Eigen::VectorXd& p, const Progress&) {
        if (p(0) > 60.0) return ResidualEvaluation{false, "too large", {}, {}};
        return decay(p);
    });
    EXPECT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values(0), 50.0, 3.0);
}

TEST(LeastSquares, SaysWhenTheFirstPointCannotBeRun) {
    const LeastSquaresReport report = fit_least_squares(start, [](const Eigen::VectorXd&, const Progress&) {
        return ResidualEvaluation{false, "no equilibrium", {}, {}};
    });
    EXPECT_EQ(report.status, FitStatus::failed);
    EXPECT_EQ(report.message, "no equilibrium");
}

/// A rate a thousand times off is found by steps that are shares of it, zero can be left, and the deviations are those
/// of the plain number.
TEST(LeastSquares, ValuesOverDecadesAreFoundFromFarOffAndFromZero) {
    const Decay decay = decay_data(5);
    const LeastSquaresReport plain = fit_least_squares(start, decay);
    ASSERT_TRUE(plain.converged());
    for (const double from : {0.0, 8e-4, 9.0}) {
        std::vector<Parameter> parameters = start;
        parameters[1].value = from;
        parameters[1].scale = 1e-2;
        parameters[1].over_decades = true;
        const LeastSquaresReport report = fit_least_squares(parameters, decay);
        ASSERT_TRUE(report.converged()) << from << ": " << report.message;
        EXPECT_NEAR(report.start(1), from, 1e-12);
        EXPECT_NEAR(report.values(1), plain.values(1), 1e-3 * plain.deviations(1));
        EXPECT_NEAR(report.deviations(1), plain.deviations(1), 1e-3 * plain.deviations(1));
    }
}

/// Numbers whose squares overflow are no data to fit.
TEST(LeastSquares, FailsWhereTheSumOfSquaresIsNotFinite) {
    Decay decay = decay_data(3);
    decay.y(7) = 1e160;
    const LeastSquaresReport report = fit_least_squares(start, decay);
    EXPECT_EQ(report.status, FitStatus::failed);
    EXPECT_NE(report.message.find("not a finite number"), std::string::npos) << report.message;
}

TEST(LeastSquares, GivesNoDeviationForWhatTheDataDoNotSee) {
    const Decay decay = decay_data(6);
    const LeastSquaresReport report = fit_least_squares(
        {{"amplitude", 20.0, 0.0, 1e3, 10.0}, {"rate_1_s", 2.0, 0.0, 10.0, 1.0}, {"unseen", 1.0, 0.0, 2.0, 1.0}},
        [&](const Eigen::VectorXd& p, const Progress&) {
            ResidualEvaluation e = decay(p.head<2>());
            e.jacobian.conservativeResize(Eigen::NoChange, 3);
            e.jacobian.col(2).setZero();
            return e;
        });
    EXPECT_TRUE(std::isnan(report.deviations(2)));
}

TEST(LeastSquares, KeepsTheBestValuesWhenCancelledInAnEvaluation) {
    const Decay decay = decay_data(7);
    std::atomic<bool> cancel{false};
    int calls = 0;
    const LeastSquaresReport report = fit_least_squares(
        start,
        [&](const Eigen::VectorXd& p, const Progress& progress) {
            cancel = ++calls == 7;
            return progress.cancelled() ? ResidualEvaluation{false, "stopped half-way", {}, {}} : decay(p);
        },
        {}, Progress({}, &cancel));
    EXPECT_EQ(report.status, FitStatus::cancelled);
    EXPECT_EQ(report.message, "stopped by the user");
    EXPECT_EQ(calls, 7);
    EXPECT_EQ(report.evaluations, 6);  // complete ones
    ASSERT_TRUE(report.usable());
    for (const FitIterate& iterate : report.history) EXPECT_GE(iterate.cost, report.cost_after);
    EXPECT_LT(report.cost_after, report.cost_before);
    EXPECT_DOUBLE_EQ(0.5 * decay(report.values).residuals.squaredNorm(), report.cost_after);
    EXPECT_GT(report.deviations.minCoeff(), 0.0);
}

TEST(LeastSquares, StopsBetweenEvaluations) {
    const Decay decay = decay_data(7);
    std::atomic<bool> cancel{false};
    const Progress progress([&](const ProgressEvent& event) { cancel = event.done >= 2; }, &cancel);
    const LeastSquaresReport report = fit_least_squares(start, decay, {}, progress);
    EXPECT_EQ(report.status, FitStatus::cancelled);
    EXPECT_EQ(report.evaluations, 2);
    EXPECT_TRUE(report.usable());
}

TEST(LeastSquares, HasNothingToKeepBeforeTheFirstEvaluation) {
    std::atomic<bool> cancel{false};
    const LeastSquaresReport report = fit_least_squares(
        start,
        [&](const Eigen::VectorXd&, const Progress&) {
            cancel = true;
            return ResidualEvaluation{false, "stopped half-way", {}, {}};
        },
        {}, Progress({}, &cancel));
    EXPECT_EQ(report.status, FitStatus::cancelled);
    EXPECT_FALSE(report.usable());
    EXPECT_EQ(report.evaluations, 0);
    EXPECT_EQ(report.values, report.start);
    EXPECT_TRUE(std::isnan(report.deviations(0)));
}

TEST(LeastSquares, ProgressCountsARunningEvaluationAsAFraction) {
    const Decay decay = decay_data(8);
    std::vector<double> seen;
    fit_least_squares(
        start,
        [&](const Eigen::VectorXd& p, const Progress& progress) {
            for (int step = 1; step <= 4; ++step) progress.report({"simulate", 0.5 * step, 2.0, "s", {}});
            std::this_thread::sleep_for(std::chrono::milliseconds(110));
            return decay(p);
        },
        {}, Progress([&](const ProgressEvent& event) {
            EXPECT_EQ(event.unit, "evaluations");
            seen.push_back(event.done);
        }));
    // Four reports at once are too many to show; the first of them is seen.
    ASSERT_GE(seen.size(), 5u);
    EXPECT_EQ(std::vector<double>(seen.begin(), seen.begin() + 5), (std::vector<double>{0.0, 0.25, 1.0, 1.25, 2.0}));
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

}  // namespace
}  // namespace myo::inverse
