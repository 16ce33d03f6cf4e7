#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "statistics/autocorrelation.hpp"
#include "statistics/distributions.hpp"
#include "statistics/periodogram.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::statistics::small_series_test {
namespace {

/// One series per length, each a marker of its own in trial 0, every 0.1 s.
ResidualLayout series_of(const std::vector<int>& lengths) {
    ResidualLayout layout;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const Eigen::Index begin = layout.size();
        for (int t = 0; t < lengths[i]; ++t) {
            layout.sample.push_back(t);
            layout.time_s.push_back(0.1 * t);
        }
        layout.series.push_back({0, static_cast<int>(i), 0, begin, layout.size()});
    }
    return layout;
}

const Eigen::Vector3d constant = Eigen::Vector3d::Ones();

TEST(SmallSeries, HaveTheInflationOfTheirOnlyLag) {
    // Lag 1 has the weight 1/2 and covariances 2/3 (of r, over all samples) and 2 (sum of s): 1 + 2 x 1/2 x 4/3 / 3.
    const ResidualLayout one = series_of({3});
    EXPECT_NEAR(variance_inflation(constant, constant, one), 1.0 + 4.0 / 9.0, 1e-12);
    EXPECT_NEAR(variance_inflation(5.0 * constant, -0.1 * constant, one), 1.0 + 4.0 / 9.0, 1e-12) << "no units";
    // Opposite correlations cancel in the sum, never below white noise.
    const Eigen::Vector3d alternating(1.0, -1.0, 1.0);
    EXPECT_EQ(variance_inflation(constant, alternating, one), 1.0);
    EXPECT_NEAR(variance_inflation(alternating, alternating, one), 1.0 + 4.0 / 9.0, 1e-12);
}

TEST(SmallSeries, ArePooledByTheEnergyThatTheyHold) {
    const ResidualLayout two = series_of({3, 3});
    Eigen::VectorXd r(6), s(6);
    r << constant, constant;
    s << constant, Eigen::Vector3d::Zero();
    EXPECT_NEAR(variance_inflation(r, s, two), 1.0 + 4.0 / 9.0, 1e-12) << "the second one holds nothing of s";
    // A second series of a white pair: lag 1 of (1, 0, -1) is zero.
    s << constant, Eigen::Vector3d(2.0, 0.0, -2.0);
    // Energies of s: 3 and 8, the inflation of the second is 1.
    EXPECT_NEAR(variance_inflation(r, s, two), (3.0 * (1.0 + 4.0 / 9.0) + 8.0) / 11.0, 1e-12);
    r.tail(3) *= 2.0;
    EXPECT_NEAR(variance_inflation(r, s, two), (3.0 * (1.0 + 4.0 / 9.0) + 32.0) / 35.0, 1e-12) << "and of r";
}

TEST(SmallSeries, CountForTheirEffectiveSamplesAndAtLeastOne) {
    // Lag 1: weight 1/2, rho^2 = 1, two pairs: (1 + 2 x 1/2) / (1 + 2 x 1/2 / 2) = 4/3.
    EXPECT_NEAR(effective_samples(constant, series_of({3})), 2.25, 1e-12);
    EXPECT_NEAR(effective_samples(Eigen::Vector3d(2.0, -2.0, 2.0), series_of({3})), 2.25, 1e-12) << "squares";
    EXPECT_EQ(effective_samples(constant, series_of({1, 1, 1})), 3.0);
    EXPECT_EQ(effective_samples(constant, series_of({0, 1, 2})), 3.0) << "no lag is tried in two samples";
    EXPECT_EQ(effective_samples(Eigen::VectorXd(), {}), 0.0);
    EXPECT_LT(effective_samples(Eigen::VectorXd::Ones(300), series_of({300})), 5.0) << "a constant is one number";
}

TEST(SmallSeries, HaveAsManyLagsAsSamplesAllow) {
    const GriddedSeries series{constant, Eigen::Vector3d::Ones()};
    const Autocovariance covariance = autocovariance(series, 10);
    EXPECT_EQ(covariance.sums, Eigen::Vector3d(3.0, 2.0, 1.0));
    EXPECT_EQ(covariance.pairs, Eigen::Vector3d(3.0, 2.0, 1.0));
    EXPECT_EQ(covariance.correlation(), constant) << "divided by the pairs: a constant has correlation 1";
    EXPECT_EQ(autocovariance(series, 0).sums.size(), 1);
    EXPECT_EQ(autocovariance({}, 5).sums, Eigen::VectorXd::Zero(1));
    EXPECT_EQ(Autocovariance{}.correlation().size(), 0);
    EXPECT_EQ((Autocovariance{Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones()}.correlation()),
              Eigen::Vector2d::Zero());
}

TEST(LjungBox, SumsSquaresOfProductsOverTheirExpectation) {
    // Eight ones, lags 1 and 2: n (n + 2) (rho(1)^2 pairs(1) + rho(2)^2 pairs(2)) / n^2 = 80 (7 + 6) / 64.
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(8);
    const LjungBoxTest test = ljung_box_test(ones, series_of({8}), 20);
    EXPECT_NEAR(test.statistic, 16.25, 1e-12);
    EXPECT_EQ(test.lags, 2.0) << "a quarter of the samples";
    EXPECT_LT(test.p, 0.05);
    EXPECT_NEAR(ljung_box_test(-3.0 * ones, series_of({8}), 20).statistic, 16.25, 1e-12);
    EXPECT_EQ(ljung_box_test(ones, series_of({8}), 1).lags, 1.0);
    const LjungBoxTest both = ljung_box_test(Eigen::VectorXd::Ones(16), series_of({8, 8}), 20);
    EXPECT_NEAR(both.statistic, 32.5, 1e-12);
    EXPECT_EQ(both.lags, 4.0);
    EXPECT_EQ(ljung_box_test(Eigen::VectorXd::Ones(7), series_of({7}), 20).lags, 0.0) << "too short";
    EXPECT_EQ(ljung_box_test(Eigen::VectorXd::Ones(7), series_of({7}), 20).p, 1.0);
}

TEST(LjungBox, IsTheSameForTheSameSeed) {
    const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(40, -1.0, 1.0).array().sin();
    const ResidualLayout layout = series_of({20, 20});
    EXPECT_EQ(ljung_box_test(r, layout, 5, 99, 3).p, ljung_box_test(r, layout, 5, 99, 3).p);
    EXPECT_NE(ljung_box_test(r, layout, 5, 99, 3).p, ljung_box_test(r, layout, 5, 99, 4).p);
}

TEST(Periods, OfAPureWaveHoldAllEnergyAtItsFrequency) {
    // Ten samples every 0.1 s last one second.
    Eigen::VectorXd wave(10);
    for (int t = 0; t < 10; ++t) wave(t) = std::cos(2.0 * std::numbers::pi * 0.3 * t + 0.4);
    const PeriodicityTest test = periodicity_test(wave, series_of({10}));
    EXPECT_NEAR(test.frequency_Hz, 3.0, 1e-9);
    EXPECT_NEAR(test.share, 1.0, 1e-12);
    EXPECT_LT(test.p, 1e-12);
    const PeriodicityTest offset = periodicity_test(Eigen::VectorXd::Constant(10, -2.0), series_of({10}));
    EXPECT_EQ(offset.frequency_Hz, 0.0);
    EXPECT_NEAR(offset.share, 1.0, 1e-12);
    EXPECT_LT(offset.p, 1e-12);
    EXPECT_EQ(periodicity_test(Eigen::VectorXd::Ones(7), series_of({7})).series, -1);
    EXPECT_EQ(periodicity_test(Eigen::VectorXd::Ones(7), series_of({7})).p, 1.0);
}

TEST(Periods, AreCorrectedForTheNumberOfFrequenciesAndSeries) {
    Eigen::VectorXd r(12);
    for (int t = 0; t < 12; ++t) r(t) = std::cos(2.0 * std::numbers::pi * t / 6.0) + (t % 3 == 0 ? 0.8 : -0.4);
    const PeriodicityTest one = periodicity_test(r, series_of({12}));
    // Six frequencies below the Nyquist frequency, with the constant one; P(share > x) = (1 - x)^5.
    EXPECT_NEAR(one.p, std::min(1.0, 6.0 * std::pow(1.0 - one.share, 5.0)), 1e-12);
    EXPECT_LT(one.p, 0.5);
    Eigen::VectorXd twice(24);
    twice << r, r;
    const PeriodicityTest two = periodicity_test(twice, series_of({12, 12}));
    EXPECT_NEAR(two.p, std::min(1.0, 2.0 * one.p), 1e-12);
    EXPECT_EQ(two.series, 0) << "the first of equals";
}

TEST(Periods, BelowThreeSamplesAreTheConstantOnly) {
    EXPECT_EQ(energy_shares(gridded(Eigen::VectorXd{{3.0}})), Eigen::VectorXd::Ones(1));
    EXPECT_EQ(energy_shares(gridded(Eigen::VectorXd{{1.0, 1.0}})), Eigen::VectorXd::Ones(1));
    EXPECT_EQ(energy_shares(gridded(Eigen::VectorXd{{1.0, -1.0}})), Eigen::VectorXd::Zero(1));
    EXPECT_EQ(mean_spectrum(Eigen::VectorXd::Ones(2), series_of({2}), 0).power.size(), 0);
    EXPECT_EQ(mean_spectrum(Eigen::VectorXd::Ones(5), series_of({5}), 1).power.size(), 0) << "no such trial";
    const Spectrum spectrum = mean_spectrum(Eigen::VectorXd::Ones(5), series_of({5}), 0);
    ASSERT_EQ(spectrum.power.size(), 3);
    EXPECT_NEAR(spectrum.power(0), 5.0, 1e-12);
    EXPECT_NEAR(spectrum.power(1), 0.0, 1e-12);
    EXPECT_NEAR(spectrum.frequency_Hz(1), 2.0, 1e-12) << "five samples last half a second";
}

TEST(SystematicPart, ExtrapolatesAParabolaToLagZero) {
    // Lags 1 and 2 of (1, 2, 3) are 4 and 3.
    const SystematicRms rising = systematic_rms(Eigen::Vector3d(1.0, 2.0, 3.0), series_of({3}));
    EXPECT_NEAR(rising.mean_square, (4.0 * 4.0 - 3.0) / 3.0, 1e-12);
    EXPECT_NEAR(rising.rms, std::sqrt(13.0 / 3.0), 1e-12);
    EXPECT_NEAR(systematic_rms(Eigen::VectorXd::Constant(9, -1.5), series_of({9})).rms, 1.5, 1e-12);
    const SystematicRms alternating = systematic_rms(Eigen::Vector4d(1.0, -1.0, 1.0, -1.0), series_of({4}));
    EXPECT_NEAR(alternating.mean_square, -5.0 / 3.0, 1e-12);
    EXPECT_EQ(alternating.rms, 0.0);
    EXPECT_TRUE(std::isfinite(alternating.deviation));
    const SystematicRms two = systematic_rms(Eigen::Vector2d(4.0, 4.0), series_of({2}));
    EXPECT_EQ(two.rms, 0.0) << "two samples have one lag, no parabola";
    EXPECT_EQ(two.deviation, 0.0);
}

TEST(SystematicPart, OfPosesIsWeightedByEntries) {
    const SystematicRms poses = systematic_rms(Eigen::Vector2d(3.0, -1.0), series_of({1, 1}));
    EXPECT_NEAR(poses.mean_square, 4.0, 1e-12) << "mean square 5 without the noise of 1";
    EXPECT_NEAR(poses.mean_square_deviation, 3.0, 1e-12) << "(2 + 4 x 4) / 2 is 9";
    EXPECT_NEAR(poses.deviation, 3.0 / (2.0 * 2.0), 1e-12);
    Eigen::VectorXd both(5);
    both << 2.0, 2.0, 2.0, 3.0, 1.0;
    // Three entries of square 4 and two poses of 4.
    EXPECT_NEAR(systematic_rms(both, series_of({3, 1, 1})).mean_square, 4.0, 1e-12);
    both.tail(2).setZero();
    EXPECT_NEAR(systematic_rms(both, series_of({3, 1, 1})).mean_square, (3.0 * 4.0 - 2.0 * 1.0) / 5.0, 1e-12);
}

TEST(VarianceOfResiduals, IsComparedWithTheLargestAcceptedNoise) {
    const Eigen::VectorXd r = Eigen::VectorXd::Constant(10, 2.0);
    const VarianceTest test = variance_test(r, 2, 0.25);
    EXPECT_EQ(test.freedom, 8.0);
    EXPECT_NEAR(test.ratio, 5.0, 1e-12);
    EXPECT_NEAR(test.p, chi_squared_tail(40.0 / 1.5625, 8.0), 1e-15);
    for (const int parameters : {10, 11}) {
        EXPECT_EQ(variance_test(r, parameters, 0.0).p, 1.0) << parameters;
        EXPECT_EQ(variance_test(r, parameters, 0.0).ratio, 0.0) << parameters;
    }
    EXPECT_EQ(variance_test(r, 9, 0.0).freedom, 1.0);
}

}  // namespace
}  // namespace myo::statistics::small_series_test
