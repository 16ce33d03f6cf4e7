#include "statistics/score_test.hpp"

#include <gtest/gtest.h>

#include "noise.hpp"
#include "support/dense.hpp"

namespace myo::statistics {
namespace {

using test::autoregressive;
using test::make_layout;
using test::signal;
using test::white;

Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
    Eigen::MatrixXd result(rows, columns);
    for (Eigen::Index j = 0; j < columns; ++j) result.col(j) = white(rows, random);
    return result;
}

TEST(NuisanceSpace, TakesOutItsSpanAndNothingElse) {
    std::mt19937 random(1);
    Eigen::MatrixXd J = random_columns(200, 4, random) * Eigen::Vector4d(1.0, 1e-9, 1e7, 1.0).asDiagonal();
    J.col(3) = 2.0 * J.col(0) + 1e-7 * J.col(2);  // not of full rank
    const NuisanceSpace nuisance(J);
    EXPECT_EQ(nuisance.rank(), 3);
    const Eigen::MatrixXd X = random_columns(200, 2, random);
    const Eigen::MatrixXd rest = nuisance.outside(X);
    EXPECT_LT((J.colwise().normalized().transpose() * rest).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((nuisance.outside(rest) - rest).norm(), 1e-12);
    EXPECT_LT(nuisance.outside(X - rest).norm(), 1e-12);  // what went was of the span
    EXPECT_EQ(NuisanceSpace(Eigen::MatrixXd(200, 0)).outside(X), X);
}

// Joint least squares over nuisance and candidate gives the same step, deviation and decrease (Frisch-Waugh-Lovell).
TEST(ScoreTest, StepIsThatOfTheJointFit) {
    std::mt19937 random(2);
    const ResidualLayout layout = make_layout();
    const Eigen::MatrixXd J = random_columns(layout.size(), 3, random);
    Eigen::MatrixXd S = random_columns(layout.size(), 2, random) * Eigen::Vector2d(1e3, 1e-4).asDiagonal();
    S.col(0) += 800.0 * J.col(1);
    const Eigen::VectorXd r = white(layout.size(), random) + S * Eigen::Vector2d(2e-4, 1e3);
    const NuisanceSpace nuisance(J);
    const ScoreTest test = score_test(project_candidate(nuisance, S), nuisance.outside(r), layout);

    Eigen::MatrixXd both(layout.size(), 5);
    both << J, S * Eigen::Vector2d(1e-3, 1e4).asDiagonal();
    const Eigen::VectorXd joint = test::least_squares(both, r);
    const Eigen::MatrixXd covariance = test::inverse(both.transpose() * both);
    EXPECT_NEAR(test.step(0), joint(3) * 1e-3, 1e-9 * std::abs(joint(3)) * 1e-3);
    EXPECT_NEAR(test.step(1), joint(4) * 1e4, 1e-9 * std::abs(joint(4)) * 1e4);
    const double inflation = static_cast<double>(layout.size()) / test.effective_samples;
    EXPECT_NEAR(test.deviation(0), std::sqrt(covariance(3, 3) * inflation) * 1e-3, 1e-12);
    EXPECT_NEAR(test.deviation(1) / (std::sqrt(covariance(4, 4) * inflation) * 1e4), 1.0, 1e-9);
    const double without = nuisance.outside(r).squaredNorm(), with = (r - both * joint).squaredNorm();
    EXPECT_NEAR(test.statistic, without - with, 1e-8 * without);
    EXPECT_NEAR(test.explained, 1.0 - with / without, 1e-10);
    EXPECT_EQ(test.freedom, 2);
}

TEST(ScoreTest, WhatRecalibrationAbsorbsIsNoCandidate) {
    std::mt19937 random(3);
    const ResidualLayout layout = make_layout();
    const Eigen::MatrixXd J = random_columns(layout.size(), 3, random);
    const NuisanceSpace nuisance(J);
    Eigen::MatrixXd S(layout.size(), 4);
    S << J * Eigen::Vector3d(1e5, -2e5, 1.0), Eigen::VectorXd::Zero(layout.size()),
        random_columns(layout.size(), 1, random), J.col(0);
    S.col(3) += 0.01 * S.col(2);
    const ProjectedCandidate candidate = project_candidate(nuisance, S);
    EXPECT_EQ(candidate.rank(), 1);
    EXPECT_LT(candidate.kept(0), 1e-12);
    EXPECT_EQ(candidate.kept(1), 0.0);
    EXPECT_NEAR(candidate.kept(2), 1.0, 0.01);
    EXPECT_NEAR(candidate.kept(3), 0.01, 0.002);
    EXPECT_EQ(candidate.determined, (std::vector<bool>{false, false, true, false}));
    const ScoreTest test = score_test(candidate, nuisance.outside(white(layout.size(), random)), layout);
    EXPECT_EQ(test.step(0), 0.0);
    EXPECT_TRUE(std::isinf(test.deviation(1)));
    EXPECT_TRUE(std::isfinite(test.deviation(2)));

    const ProjectedCandidate nothing = project_candidate(nuisance, S.leftCols(2));
    EXPECT_EQ(nothing.rank(), 0);
    const ScoreTest none = score_test(nothing, nuisance.outside(white(layout.size(), random)), layout);
    EXPECT_EQ(none.p, 1.0);
    EXPECT_EQ(none.p_white, 1.0);
    EXPECT_EQ(principal_cosine(nothing, candidate), 0.0);
}

// Rates of false alarms of a slow candidate of two parameters beside slow nuisances.
struct FalseAlarms {
    double white = 0.0;
    double corrected = 0.0;
};

FalseAlarms false_alarms(const ResidualLayout& layout, const std::function<Eigen::VectorXd(std::mt19937&)>& draw) {
    const auto wave = [&](double frequency, double phase) {
        return signal(layout, [=](const ResidualSeries& series, double t) {
            return (series.marker + 1.0) * std::cos(frequency * t + phase + series.axis);
        });
    };
    Eigen::MatrixXd J(layout.size(), 2), S(layout.size(), 2);
    J << wave(3.0, 0.0), wave(9.0, 1.0);
    S << wave(4.0, 0.5), wave(0.0, 0.3);
    const NuisanceSpace nuisance(J);
    const ProjectedCandidate candidate = project_candidate(nuisance, S);
    std::mt19937 random(4);
    FalseAlarms rates;
    constexpr int draws = 400;
    for (int k = 0; k < draws; ++k) {
        const ScoreTest test = score_test(candidate, nuisance.outside(draw(random)), layout);
        rates.white += (test.p_white < 0.05) / static_cast<double>(draws);
        rates.corrected += (test.p < 0.05) / static_cast<double>(draws);
    }
    testing::Test::RecordProperty("white", std::to_string(rates.white));
    testing::Test::RecordProperty("corrected", std::to_string(rates.corrected));
    return rates;
}

TEST(ScoreTest, FalseAlarmsOfWhiteNoise) {
    const ResidualLayout layout = make_layout({.gaps = 0.2});
    const FalseAlarms rates = false_alarms(layout, [&](std::mt19937& random) { return white(layout.size(), random); });
    EXPECT_NEAR(rates.white, 0.05, 0.033);
    EXPECT_NEAR(rates.corrected, 0.05, 0.033);
}

TEST(ScoreTest, FalseAlarmsOfColouredNoise) {
    const ResidualLayout layout = make_layout();
    const FalseAlarms rates = false_alarms(layout,
                                           [&](std::mt19937& random) { return autoregressive(layout, 0.8, random); });
    EXPECT_GT(rates.white, 0.4);  // what the correction is for
    EXPECT_LE(rates.corrected, 0.1);
    EXPECT_GE(rates.corrected, 0.01);
}

TEST(ScoreTest, TheSizeOfTheNoiseDoesNotMatterAfterTheCorrection) {
    const ResidualLayout layout = make_layout();
    const FalseAlarms rates = false_alarms(
        layout, [&](std::mt19937& random) { return Eigen::VectorXd(2.0 * white(layout.size(), random)); });
    EXPECT_GT(rates.white, 0.3);
    EXPECT_NEAR(rates.corrected, 0.05, 0.033);
}

TEST(ScoreTest, TheTrueEffectComesFirst) {
    std::mt19937 random(5);
    const ResidualLayout layout = make_layout();
    const NuisanceSpace nuisance(random_columns(layout.size(), 2, random));
    int first = 0;
    for (int k = 0; k < 50; ++k) {
        std::vector<ProjectedCandidate> candidates;
        std::vector<Eigen::MatrixXd> tangents;
        for (int c = 0; c < 10; ++c) {
            tangents.push_back(autoregressive(layout, 0.95, random));
            candidates.push_back(project_candidate(nuisance, tangents.back()));
        }
        const Eigen::VectorXd r = nuisance.outside(white(layout.size(), random) + 0.2 * tangents[3]);
        std::vector<double> p;
        for (const ProjectedCandidate& candidate : candidates) p.push_back(score_test(candidate, r, layout).p);
        first += std::min_element(p.begin(), p.end()) - p.begin() == 3 && holm_adjusted(p)[3] < 0.01;
    }
    EXPECT_GE(first, 49);
}

TEST(ScoreTest, CosinesTellWhatCannotBeToldApart) {
    std::mt19937 random(6);
    const Eigen::Index rows = 300;
    const NuisanceSpace nuisance(random_columns(rows, 2, random));
    const Eigen::MatrixXd base = test::orthonormal(nuisance.outside(random_columns(rows, 4, random)));
    const auto candidate = [&](const Eigen::MatrixXd& S) { return project_candidate(nuisance, S); };
    const double angle = 0.3;
    const Eigen::VectorXd turned = -5.0 * (std::cos(angle) * base.col(0) + std::sin(angle) * base.col(1));
    EXPECT_NEAR(principal_cosine(candidate(base.col(0)), candidate(turned)), -std::cos(angle), 1e-10);
    EXPECT_NEAR(principal_cosine(candidate(base.col(0)), candidate(base.col(2))), 0.0, 1e-10);
    // Two directions each: the largest canonical correlation, whatever the basis.
    Eigen::MatrixXd a(rows, 2), b(rows, 2);
    a << base.col(0) + base.col(2), base.col(2);
    b << turned, base.col(3) + turned;
    EXPECT_NEAR(principal_cosine(candidate(a), candidate(b)), std::cos(angle), 1e-10);
    const Eigen::MatrixXd all = principal_cosines({candidate(a), candidate(b), candidate(base.col(3))});
    EXPECT_EQ(all, Eigen::MatrixXd(all.transpose()));
    EXPECT_NEAR(all(1, 2), 1.0, 1e-10);
    EXPECT_NEAR(all(0, 2), 0.0, 1e-10);
    EXPECT_EQ(all(0, 0), 1.0);
}

TEST(Holm, StepsDown) {
    const std::vector<double> adjusted = holm_adjusted({0.04, 0.005, 0.9, 0.02});
    EXPECT_DOUBLE_EQ(adjusted[1], 0.02);
    EXPECT_DOUBLE_EQ(adjusted[3], 0.06);
    EXPECT_DOUBLE_EQ(adjusted[0], 0.08);
    EXPECT_DOUBLE_EQ(adjusted[2], 0.9);
    EXPECT_TRUE(holm_adjusted({}).empty());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform;
    int wrong = 0;
    for (int k = 0; k < 2000; ++k) {
        std::vector<double> p(20);
        for (double& value : p) value = uniform(random);
        const std::vector<double> holm = holm_adjusted(p);
        wrong += *std::min_element(holm.begin(), holm.end()) < 0.05;
    }
    EXPECT_NEAR(wrong / 2000.0, 0.05, 0.015);
}

}  // namespace
}  // namespace myo::statistics
