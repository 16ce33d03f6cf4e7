#include <gtest/gtest.h>

#include "noise.hpp"
#include "statistics/evidence.hpp"
#include "statistics/linear_cross_validation.hpp"
#include "support/dense.hpp"

namespace myo::statistics {
namespace {

using test::make_layout;
using test::white;

TEST(Folds, AreTrialsWhereThereAreSeveral) {
    const ResidualLayout layout = make_layout({.trials = 3, .gaps = 0.2});
    const Folds folds = make_folds(layout);
    EXPECT_TRUE(folds.by_trial);
    EXPECT_EQ(folds.count, 3);
    for (const ResidualSeries& series : layout.series)
        for (Eigen::Index k = series.begin; k < series.end; ++k)
            EXPECT_EQ(folds.of_entry[static_cast<std::size_t>(k)], series.trial);
}

TEST(Folds, AreBlocksOfTimeWithAGuardInOneTrial) {
    const ResidualLayout layout = make_layout({.trials = 1, .samples = 101, .gaps = 0.2});
    const Folds folds = make_folds(layout, {.blocks = 4, .guard_s = 0.045});
    EXPECT_FALSE(folds.by_trial);
    EXPECT_EQ(folds.count, 4);
    for (std::size_t k = 0; k < folds.of_entry.size(); ++k) {
        const double t = layout.time_s[k];
        const bool guarded = std::abs(t - 0.25) < 0.0225 || std::abs(t - 0.5) < 0.0225 || std::abs(t - 0.75) < 0.0225;
        EXPECT_EQ(folds.of_entry[k], guarded ? -1 : std::min(3, static_cast<int>(t / 0.25))) << t;
    }
    EXPECT_EQ(make_folds(make_layout({.trials = 1, .samples = 3}), {.blocks = 8}).count, 3);
    EXPECT_EQ(make_folds({}).count, 0);
}

TEST(Folds, OfTimeCutAllTrialsAlike) {
    const ResidualLayout layout = make_layout({.trials = 3, .samples = 101});
    const Folds folds = time_folds(layout, {.blocks = 4});
    EXPECT_EQ(folds.count, 4);
    for (std::size_t k = 0; k < folds.of_entry.size(); ++k)
        EXPECT_EQ(folds.of_entry[k], std::min(3, static_cast<int>(layout.time_s[k] / 0.25)));
}

struct Problem {
    ResidualLayout layout = make_layout({.trials = 3});
    Eigen::MatrixXd J;
    Eigen::VectorXd y;
    Eigen::VectorXd fitted;
};

Problem linear_problem() {
    Problem problem;
    std::mt19937 random(1);
    const Eigen::Index N = problem.layout.size();
    problem.J.resize(N, 3);
    problem.J << white(N, random), 1e6 * white(N, random), 1e-5 * white(N, random);
    problem.y = problem.J * Eigen::Vector3d(1.0, 2e-6, 3e4) + white(N, random);
    problem.fitted = test::least_squares(problem.J, problem.y);
    return problem;
}

TEST(LinearCrossValidation, IsExactForALinearModel) {
    const Problem problem = linear_problem();
    const Folds folds = make_folds(problem.layout);
    const LinearCrossValidation result = linear_cross_validation(problem.y - problem.J * problem.fitted, problem.J,
                                                                 folds);
    ASSERT_EQ(result.folds.size(), 3U);
    double total = 0.0;
    for (int f = 0; f < 3; ++f) {
        std::vector<Eigen::Index> inside, outside;
        for (Eigen::Index k = 0; k < problem.layout.size(); ++k)
            (folds.of_entry[static_cast<std::size_t>(k)] == f ? inside : outside).push_back(k);
        const Eigen::MatrixXd others = problem.J(outside, Eigen::all);
        const Eigen::VectorXd refit = test::least_squares(others, problem.y(outside));
        const Eigen::VectorXd held_out = problem.y(inside) - problem.J(inside, Eigen::all) * refit;
        const auto& fold = result.folds[static_cast<std::size_t>(f)];
        for (int j = 0; j < 3; ++j) EXPECT_NEAR((problem.fitted + fold.change)(j) / refit(j), 1.0, 1e-10);
        EXPECT_NEAR(fold.squares, held_out.squaredNorm(), 1e-8);
        EXPECT_EQ(fold.samples, static_cast<Eigen::Index>(inside.size()));
        EXPECT_EQ(fold.undetermined, 0);
        total += held_out.squaredNorm();
    }
    EXPECT_NEAR(result.squares, total, 1e-8);
    EXPECT_NEAR(result.residual.squaredNorm(), total, 1e-8);
}

// A parameter of one trial stays as fitted where that is left out, also where the errors of its derivatives seem to
// tell of it elsewhere.
TEST(LinearCrossValidation, KeepsWhatOnlyOneFoldKnows) {
    for (const double error : {0.0, 1e-3}) {
        Problem problem = linear_problem();
        for (const ResidualSeries& series : problem.layout.series)
            if (series.trial != 1) problem.J.col(2).segment(series.begin, series.size()) *= error;
        problem.fitted = test::least_squares(problem.J, problem.y);
        const Eigen::VectorXd r = problem.y - problem.J * problem.fitted;
        const Folds folds = make_folds(problem.layout);
        const LinearCrossValidation result = linear_cross_validation(r, problem.J, folds);
        EXPECT_EQ(result.folds[1].undetermined, 1);
        EXPECT_EQ(result.folds[0].undetermined, 0);
        EXPECT_NEAR(result.folds[1].change(2) / problem.fitted(2), 0.0, 1e-3);
        const LinearCrossValidation without = linear_cross_validation(r, problem.J.leftCols(2), folds);
        EXPECT_NEAR(result.folds[1].squares / without.folds[1].squares, 1.0, 0.1);
    }
}

// A parameter that does nothing in truth costs one unit of prediction per fitted and one per predicted sample on
// average.
TEST(LinearCrossValidation, UselessParametersDoNotPay) {
    std::mt19937 random(2);
    const ResidualLayout layout = make_layout({.trials = 1, .markers = 2, .samples = 60});
    const Folds folds = make_folds(layout, {.blocks = 5});
    double useless = 0.0, useful = 0.0;
    constexpr int draws = 300;
    for (int k = 0; k < draws; ++k) {
        const Eigen::MatrixXd J = white(layout.size(), random);
        const Eigen::VectorXd noise = white(layout.size(), random);
        const auto gain = [&](const Eigen::VectorXd& y) {
            const double fitted = J.col(0).dot(y) / J.squaredNorm();
            return (y.squaredNorm() - linear_cross_validation(y - J * fitted, J, folds).squares) / draws;
        };
        useless += gain(noise);
        useful += gain(noise + 0.3 * J.col(0));
    }
    EXPECT_NEAR(useless, -1.25, 0.5);  // -J'J over the folds / J'J outside: -1 / (1 - 1 / 5)
    EXPECT_GT(useful, 20.0);
}

TEST(LinearCrossValidation, GuardsAreNotJudgedAndNoParametersChangeNothing) {
    std::mt19937 random(3);
    const ResidualLayout layout = make_layout({.trials = 1});
    const Folds folds = make_folds(layout, {.blocks = 3, .guard_s = 0.1});
    const Eigen::VectorXd r = white(layout.size(), random);
    const LinearCrossValidation result = linear_cross_validation(r, Eigen::MatrixXd(layout.size(), 0), folds);
    double squares = 0.0;
    for (Eigen::Index k = 0; k < r.size(); ++k) {
        const bool judged = folds.of_entry[static_cast<std::size_t>(k)] >= 0;
        EXPECT_EQ(std::isnan(result.residual(k)), !judged);
        if (judged) squares += r(k) * r(k);
    }
    EXPECT_LT(result.samples, layout.size());
    EXPECT_NEAR(result.squares, squares, 1e-9);
    EXPECT_NEAR(result.mean_square(), squares / static_cast<double>(result.samples), 1e-12);
}

TEST(Evidence, WeightsAreThoseOfTheDifferences) {
    const std::vector<double> weights = evidence_weights({10.0, 12.0, std::numeric_limits<double>::infinity(), 1000.0});
    EXPECT_NEAR(weights[0] / weights[1], std::exp(1.0), 1e-12);
    EXPECT_EQ(weights[2], 0.0);
    EXPECT_NEAR(weights[0] + weights[1] + weights[3], 1.0, 1e-12);
    const std::vector<double> tempered = evidence_weights({10.0, 12.0}, 2.0);
    EXPECT_NEAR(tempered[0] / tempered[1], std::exp(0.5), 1e-12);
    EXPECT_TRUE(evidence_weights({}).empty());
    EXPECT_EQ(evidence_weights({std::nan("")})[0], 0.0);
}

TEST(Evidence, CriterionPaysForParameters) {
    EXPECT_DOUBLE_EQ(information_criterion(200.0, 100.0, 50.0, 3), 50.0 * std::log(2.0) + 3.0 * std::log(50.0));
    // Near the stated noise both count the same decrease.
    const double far = information_criterion(1001.0, 1000.0, 400.0, 2) -
                       information_criterion(1000.0, 1000.0, 400.0, 2);
    const double known = information_criterion_known_noise(1001.0, 1000.0, 400.0, 2) -
                         information_criterion_known_noise(1000.0, 1000.0, 400.0, 2);
    EXPECT_NEAR(far, known, 1e-3);
    EXPECT_NEAR(known, 0.4, 1e-12);
}

// Criteria that are `exaggeration` times too sure are brought back by that temperature.
TEST(Evidence, TemperatureIsFoundFromJudgedComparisons) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform;
    for (const double exaggeration : {1.0, 6.0}) {
        std::vector<JudgedComparison> comparisons;
        for (int k = 0; k < 3000; ++k) {
            JudgedComparison comparison;
            for (int c = 0; c < 4; ++c) comparison.criteria.push_back(6.0 * uniform(random));
            double mark = uniform(random);
            const std::vector<double> weights = evidence_weights(comparison.criteria);
            while (comparison.truth < 3 && mark > weights[comparison.truth]) mark -= weights[comparison.truth++];
            for (double& criterion : comparison.criteria) criterion *= exaggeration;
            comparisons.push_back(comparison);
        }
        EXPECT_NEAR(calibrated_temperature(comparisons) / exaggeration, 1.0, 0.1);
    }
    EXPECT_EQ(calibrated_temperature({}), 1.0);
    EXPECT_NEAR(calibrated_temperature({{{0.0, 5.0}, 0}}), 0.05, 1e-3);  // always right: as sure as allowed
}

}  // namespace
}  // namespace myo::statistics
