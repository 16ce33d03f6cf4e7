#include "statistics/residual_tests.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "noise.hpp"

namespace myo::statistics {
namespace {

using test::make_layout;
using test::Recorded;
using test::signal;
using test::white;

constexpr int white_draws = 400;

// How many of the draws of white noise fall below 0.05 and 0.0025 in each test: variance, Ljung-Box, periodicity,
// space.
struct Rates {
    std::array<double, 4> below_20th{};
    std::array<double, 4> below_400th{};
    double family = 0.0;
};

Rates rates_of(const Recorded& recorded,
               const std::function<Eigen::VectorXd(const ResidualLayout&, std::mt19937&)>& draw) {
    Rates rates;
    const ResidualLayout layout = make_layout(recorded);
    std::mt19937 random(recorded.seed);
    ResidualTestOptions options;
    options.noise_tolerance = 0.0;
    options.draws = 99;
    for (int k = 0; k < white_draws; ++k) {
        options.seed = static_cast<unsigned>(k);
        const ResidualTests tests = test_residuals(draw(layout, random), layout, 0, options);
        const std::array<double, 4> p{tests.variance.p, tests.ljung_box.p, tests.periodicity.p, tests.space.p};
        for (std::size_t i = 0; i < p.size(); ++i) {
            rates.below_20th[i] += (p[i] < 0.05) / static_cast<double>(white_draws);
            rates.below_400th[i] += (p[i] < 0.0025) / static_cast<double>(white_draws);
        }
        rates.family += tests.significant() / static_cast<double>(white_draws);
    }
    return rates;
}

void expect_honest(const Rates& rates) {
    // Three deviations of a count of 400 are 0.033 at 0.05 and 0.0075 at 0.0025.
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LE(rates.below_20th[i], 0.083) << i;
        EXPECT_LE(rates.below_400th[i], 0.0125) << i;
        testing::Test::RecordProperty("below_0.05_of_" + std::to_string(i), std::to_string(rates.below_20th[i]));
    }
    for (const std::size_t exact : {0U, 1U, 3U}) EXPECT_GE(rates.below_20th[exact], 0.017) << exact;
    EXPECT_LE(rates.family, 0.025);
    testing::Test::RecordProperty("family_of_0.01", std::to_string(rates.family));
}

Eigen::VectorXd white_noise(const ResidualLayout& layout, std::mt19937& random) { return white(layout.size(), random); }

TEST(ResidualTests, FalseAlarmsOfWhiteNoise) { expect_honest(rates_of({}, white_noise)); }

TEST(ResidualTests, FalseAlarmsWithGaps) { expect_honest(rates_of({.gaps = 0.3}, white_noise)); }

TEST(ResidualTests, FalseAlarmsOfOneShortTrial) {
    expect_honest(rates_of({.trials = 1, .markers = 8, .samples = 40}, white_noise));
}

TEST(ResidualTests, MarkersMayBeOfUnequalNoise) {
    const Rates rates = rates_of({}, [](const ResidualLayout& layout, std::mt19937& random) {
        const Eigen::VectorXd noise = white(layout.size(), random);
        return Eigen::VectorXd(noise.cwiseProduct(
            signal(layout, [](const ResidualSeries& series, double) { return series.marker == 1 ? 2.0 : 0.3; })));
    });
    for (const std::size_t i : {1U, 2U, 3U}) EXPECT_LE(rates.below_20th[i], 0.083) << i;
}

TEST(ResidualTests, VarianceAllowsForTheToleranceAndSeesMore) {
    const ResidualLayout layout = make_layout();
    std::mt19937 random(6);
    int within = 0, beyond = 0;
    for (int k = 0; k < 100; ++k) {
        const Eigen::VectorXd noise = white(layout.size(), random);
        within += variance_test(1.04 * noise, 0, 0.05).p < 0.01;
        beyond += variance_test(1.12 * noise, 0, 0.05).p < 0.01;
    }
    EXPECT_LE(within, 3);
    EXPECT_GE(beyond, 97);
    EXPECT_NEAR(variance_test(white(100'000, random), 1000, 0.0).ratio, 1.0 / 0.99, 0.02);
    EXPECT_EQ(variance_test(Eigen::VectorXd(), 3, 0.05).p, 1.0);
}

TEST(ResidualTests, SeeASignalOfASixthOfTheNoisesEnergy) {
    const ResidualLayout layout = make_layout({.gaps = 0.1});
    const Eigen::VectorXd sway = signal(layout, [](const ResidualSeries& series, double t) {
        return 0.35 * (series.marker + 1) * std::cos(2.0 * std::numbers::pi * 4.0 * t + 0.2);
    });
    std::mt19937 random(7);
    int colour = 0, space = 0;
    double deviation = 0.0;
    const double truth = sway.squaredNorm() / static_cast<double>(sway.size());
    for (unsigned k = 0; k < 50; ++k) {
        const ResidualTests tests = test_residuals(1.3 * white(layout.size(), random) + sway, layout, 0,
                                                   {.draws = 99, .seed = k});
        colour += tests.colour_fired();
        space += tests.space_fired();
        deviation += (tests.systematic.mean_square - truth) / 50.0;
    }
    EXPECT_GE(colour, 49);
    EXPECT_GE(space, 49);
    EXPECT_NEAR(deviation, 0.0, 0.033);  // four deviations, whatever the size of the white noise
}

TEST(ResidualTests, NameFrequencySeriesAndPattern) {
    const ResidualLayout layout = make_layout({.trials = 1, .samples = 200});
    std::mt19937 random(8);
    const Eigen::VectorXd wave = signal(layout, [](const ResidualSeries& series, double t) {
        return series.marker == 2 && series.axis != 1
                   ? (series.axis == 0 ? -3.0 : 1.5) * std::sin(2.0 * std::numbers::pi * 8.0 * t)
                   : 0.0;
    });
    const Eigen::VectorXd r = white(layout.size(), random) + wave;
    const PeriodicityTest periodicity = periodicity_test(r, layout);
    EXPECT_EQ(periodicity.series, 6);
    EXPECT_NEAR(periodicity.frequency_Hz, 8.0, 1e-9);
    EXPECT_NEAR(periodicity.share, 4.5 / 5.5, 0.06);
    const SpaceTest space = space_test(r, layout);
    ASSERT_EQ(space.trials.size(), 1U);
    EXPECT_NEAR(space.trials[0].pattern(6), 0.894, 0.05);
    EXPECT_NEAR(space.trials[0].pattern(8), -0.447, 0.08);
    EXPECT_NEAR(space.trials[0].share, (1.0 + 0.5 * 11.25) / (9.0 + 0.5 * 11.25), 0.06);
    EXPECT_LT(space.p, 1e-6);
}

TEST(ResidualTests, AnOffsetIsMisfit) {
    const ResidualLayout layout = make_layout();
    std::mt19937 random(9);
    const Eigen::VectorXd offset = signal(
        layout, [](const ResidualSeries& series, double) { return series.axis == 2 ? 0.6 : 0.0; });
    const ResidualTests tests = test_residuals(white(layout.size(), random) + offset, layout, 0);
    EXPECT_TRUE(tests.colour_fired());
    EXPECT_TRUE(tests.space_fired());
    EXPECT_NEAR(tests.systematic.rms, 0.6 / std::sqrt(3.0), 3.0 * tests.systematic.deviation);
}

TEST(ResidualTests, SystematicRmsHasTheStatedDeviation) {
    const ResidualLayout layout = make_layout();
    std::mt19937 random(10);
    for (const double amplitude : {0.0, 1.0}) {
        const Eigen::VectorXd slow = signal(layout, [&](const ResidualSeries& series, double t) {
            return amplitude * std::cos(12.0 * t + series.axis);
        });
        const double truth = slow.squaredNorm() / static_cast<double>(layout.size());
        double error = 0.0, squares = 0.0, stated = 0.0;
        for (int k = 0; k < white_draws; ++k) {
            const SystematicRms rms = systematic_rms(white(layout.size(), random) + slow, layout);
            error += (rms.mean_square - truth) / white_draws;
            squares += std::pow(rms.mean_square - truth, 2) / white_draws;
            stated += std::pow(rms.mean_square_deviation, 2) / white_draws;
        }
        EXPECT_NEAR(error, 0.0, 4.0 * std::sqrt(squares / white_draws)) << amplitude;
        EXPECT_NEAR(squares / stated, 1.0, 0.25) << amplitude;
    }
}

TEST(ResidualTests, SystematicPartOfPosesIsWhatExceedsTheStatedNoise) {
    const ResidualLayout layout = make_layout({.trials = 12, .markers = 4, .samples = 1});
    std::mt19937 random(5);
    for (const double size : {0.0, 1.0, 8.0}) {
        const Eigen::VectorXd pattern = size * white(layout.size(), random);
        const double truth = pattern.squaredNorm() / static_cast<double>(pattern.size());
        double error = 0.0, squares = 0.0, stated = 0.0;
        for (int k = 0; k < white_draws; ++k) {
            const SystematicRms rms = systematic_rms(pattern + white(layout.size(), random), layout);
            error += (rms.mean_square - truth) / white_draws;
            squares += std::pow(rms.mean_square - truth, 2) / white_draws;
            stated += std::pow(rms.mean_square_deviation, 2) / white_draws;
        }
        EXPECT_NEAR(error, 0.0, 4.0 * std::sqrt(squares / white_draws)) << size;
        EXPECT_NEAR(squares / stated, 1.0, 0.3) << size;
    }
}

TEST(ResidualTests, SurviveWhatIsTooLittle) {
    EXPECT_FALSE(test_residuals(Eigen::VectorXd(), {}, 0).significant());
    for (const int samples : {1, 2, 3, 5}) {
        const ResidualLayout layout = make_layout({.trials = 1, .markers = 1, .samples = samples});
        std::mt19937 random(11);
        const ResidualTests tests = test_residuals(white(layout.size(), random), layout, 2);
        EXPECT_FALSE(tests.significant()) << samples;
        EXPECT_TRUE(std::isfinite(tests.systematic.deviation));
    }
    const ResidualLayout layout = make_layout();
    EXPECT_FALSE(test_residuals(Eigen::VectorXd::Zero(layout.size()), layout, 2).significant());
}

}  // namespace
}  // namespace myo::statistics
