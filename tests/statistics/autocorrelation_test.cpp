#include <gtest/gtest.h>

#include <Eigen/LU>

#include <numbers>

#include "noise.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/periodogram.hpp"

namespace myo::statistics {
namespace {

using test::autoregressive;
using test::make_layout;
using test::signal;
using test::white;

TEST(Autocorrelation, CountsThePairsThatAreThere) {
    ResidualLayout layout;
    layout.series = {{0, 0, 0, 0, 4}};
    layout.sample = {0, 1, 3, 4};
    layout.time_s = {0.0, 0.1, 0.3, 0.4};
    const Eigen::VectorXd r{{1.0, 2.0, 3.0, 5.0}};
    const Autocovariance covariance = pooled_autocovariance(r, layout, 6);
    EXPECT_EQ(covariance.sums, (Eigen::VectorXd{{39.0, 2.0 + 15.0, 6.0, 3.0 + 10.0, 5.0, 0.0, 0.0}}));
    EXPECT_EQ(covariance.pairs, (Eigen::VectorXd{{4.0, 2.0, 1.0, 2.0, 1.0, 0.0, 0.0}}));
    EXPECT_DOUBLE_EQ(covariance.correlation()(0), 1.0);
    EXPECT_DOUBLE_EQ(covariance.correlation()(1), 8.5 / 9.75);
    EXPECT_EQ(covariance.correlation()(6), 0.0);
}

TEST(Autocorrelation, OfAutoregressiveNoiseIsAPower) {
    std::mt19937 random(1);
    const ResidualLayout layout = make_layout({.trials = 4, .markers = 10, .samples = 500});
    const Eigen::VectorXd rho = pooled_autocovariance(autoregressive(layout, 0.8, random), layout, 10).correlation();
    for (int lag = 0; lag <= 10; ++lag) EXPECT_NEAR(rho(lag), std::pow(0.8, lag), 0.02) << lag;
    EXPECT_LT(
        pooled_autocovariance(white(layout.size(), random), layout, 10, 2).correlation().tail(10).cwiseAbs().maxCoeff(),
        0.03);
}

// For autoregressive r and s: 1 + 2 sum (a b)^k = (1 + a b) / (1 - a b).
TEST(Autocorrelation, InflationIsBartletts) {
    std::mt19937 random(2);
    const ResidualLayout layout = make_layout({.trials = 4, .markers = 10, .samples = 600});
    for (const double a : {0.0, 0.6, 0.9}) {
        const Eigen::VectorXd r = autoregressive(layout, a, random);
        EXPECT_NEAR(
            variance_inflation(r, autoregressive(layout, 0.9, random), layout) / ((1.0 + 0.9 * a) / (1.0 - 0.9 * a)),
            1.0, 0.08)
            << a;
        const double samples = static_cast<double>(layout.size());
        EXPECT_NEAR(effective_samples(r, layout) / samples / ((1.0 - a * a) / (1.0 + a * a)), 1.0, 0.2) << a;
    }
    // A short trial, or noise that alternates, is never worth more than its samples.
    const Eigen::VectorXd alternating = signal(
        layout, [](const ResidualSeries&, double t) { return std::cos(std::numbers::pi * t / 0.01); });
    EXPECT_EQ(variance_inflation(alternating, autoregressive(layout, 0.9, random), layout), 1.0);
    EXPECT_EQ(variance_inflation(Eigen::VectorXd::Zero(layout.size()), alternating, layout), 1.0);
}

TEST(Autocorrelation, InflationIsTheVarianceOfProducts) {
    std::mt19937 random(3);
    const ResidualLayout layout = make_layout({.trials = 1, .markers = 2, .samples = 200, .gaps = 0.3});
    const ResidualLayout complete = make_layout({.trials = 1, .markers = 2, .samples = 200});
    const Eigen::VectorXd s = signal(
        layout, [](const ResidualSeries& series, double t) { return std::cos(4.0 * t + series.axis); });
    double variance = 0.0, predicted = 0.0;
    constexpr int draws = 600;
    for (int draw = 0; draw < draws; ++draw) {
        const Eigen::VectorXd full = autoregressive(complete, 0.85, random);
        Eigen::VectorXd r(layout.size());  // the same noise, seen with gaps
        for (std::size_t i = 0; i < layout.series.size(); ++i)
            for (Eigen::Index k = layout.series[i].begin; k < layout.series[i].end; ++k)
                r(k) = full(complete.series[i].begin + layout.sample[static_cast<std::size_t>(k)]);
        variance += std::pow(r.dot(s), 2) / draws;
        predicted += r.squaredNorm() / static_cast<double>(r.size()) * s.squaredNorm() *
                     variance_inflation(r, s, layout) / draws;
    }
    EXPECT_NEAR(predicted / variance, 1.0, 0.15);  // three deviations of a variance from 600 draws are 0.17
    RecordProperty("predicted_over_true_variance", std::to_string(predicted / variance));
}

TEST(Periodogram, SharesAreThoseOfLeastSquares) {
    std::mt19937 random(4);
    const ResidualLayout layout = make_layout({.trials = 1, .markers = 1, .samples = 61, .gaps = 0.3});
    const Eigen::VectorXd r = white(layout.size(), random);
    const ResidualSeries& series = layout.series[1];
    const GriddedSeries grid = gridded(r, layout, series);
    const Eigen::VectorXd shares = energy_shares(grid);
    ASSERT_EQ(shares.size(), (grid.values.size() + 1) / 2);
    const Eigen::VectorXd own = r.segment(series.begin, series.size());
    for (Eigen::Index k = 1; k < shares.size(); ++k) {
        Eigen::MatrixXd waves(series.size(), 2);
        for (Eigen::Index i = 0; i < series.size(); ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) /
                                 static_cast<double>(grid.values.size()) *
                                 layout.sample[static_cast<std::size_t>(series.begin + i)];
            waves.row(i) << std::cos(angle), std::sin(angle);
        }
        const Eigen::Matrix2d normal = waves.transpose() * waves;
        const Eigen::Vector2d right = waves.transpose() * own;
        const double determinant = normal.determinant();
        const Eigen::Vector2d fit{(normal(1, 1) * right(0) - normal(0, 1) * right(1)) / determinant,
                                  (normal(0, 0) * right(1) - normal(1, 0) * right(0)) / determinant};
        EXPECT_NEAR(shares(k), right.dot(fit) / own.squaredNorm(), 1e-12) << k;
    }
    EXPECT_NEAR(shares(0), std::pow(own.sum(), 2) / static_cast<double>(own.size()) / own.squaredNorm(), 1e-12);
    // Complete series of odd length: Parseval.
    EXPECT_NEAR(energy_shares(gridded(white(101, random))).sum(), 1.0, 1e-12);
    EXPECT_EQ(energy_shares(gridded(Eigen::VectorXd(Eigen::VectorXd::Zero(20)))).sum(), 0.0);
}

TEST(Periodogram, SpectrumHasItsPeakAtTheFrequencyAndOneForWhiteNoise) {
    std::mt19937 random(5);
    const ResidualLayout layout = make_layout({.trials = 2, .markers = 20, .samples = 200, .gaps = 0.1});
    const Eigen::VectorXd noise = white(layout.size(), random);
    const Spectrum plain = mean_spectrum(noise, layout, 1);
    EXPECT_NEAR(plain.power.mean(), 1.0, 0.03);
    EXPECT_NEAR(plain.frequency_Hz(1), 0.5, 1e-9);
    const Eigen::VectorXd wave = signal(
        layout, [](const ResidualSeries&, double t) { return 2.0 * std::sin(2.0 * std::numbers::pi * 7.5 * t); });
    Eigen::Index peak = 0;
    mean_spectrum(noise + wave, layout, 0).power.maxCoeff(&peak);
    EXPECT_NEAR(plain.frequency_Hz(peak), 7.5, 1e-9);
}

}  // namespace
}  // namespace myo::statistics
