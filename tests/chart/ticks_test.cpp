#include "chart/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "support/not_finite.hpp"

namespace myo::chart {
namespace {

using test::infinity;

// What every axis owes its reader: several ticks, inside, ascending, with labels that differ.
void expect_readable(const Ticks& ticks) {
    ASSERT_TRUE(std::isfinite(ticks.lowest) && std::isfinite(ticks.highest));
    ASSERT_LT(ticks.lowest, ticks.highest);
    ASSERT_GE(ticks.values.size(), 2u);
    ASSERT_LE(ticks.values.size(), 32u);
    ASSERT_EQ(ticks.values.size(), ticks.labels.size());
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        EXPECT_GE(ticks.values[i], ticks.lowest);
        EXPECT_LE(ticks.values[i], ticks.highest);
        EXPECT_TRUE(i == 0 || ticks.values[i] > ticks.values[i - 1]);
    }
    const std::set<std::string> different(ticks.labels.begin(), ticks.labels.end());
    EXPECT_EQ(different.size(), ticks.labels.size()) << ticks.labels[0];
}

TEST(LinearTicks, AreRound) {
    const Ticks ticks = linear_ticks(0.0, 3.0, 6);
    EXPECT_EQ(ticks.labels, (std::vector<std::string>{"0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"}));
    EXPECT_EQ(linear_ticks(-1.2, 1.1, 5).labels, (std::vector<std::string>{"−1.0", "−0.5", "0.0", "0.5", "1.0"}));
}

TEST(LinearTicks, ScaleTheLabelsOfLargeAndSmallNumbers) {
    const Ticks pascal = linear_ticks(1e5, 3e5, 4);
    EXPECT_EQ(pascal.factor, "10³");
    EXPECT_EQ(pascal.labels.front(), "100");
    const Ticks metres = linear_ticks(0.0, 2e-4, 4);
    EXPECT_EQ(metres.factor, "10⁻⁶");
    EXPECT_EQ(metres.labels.back(), "200");
    EXPECT_EQ(linear_ticks(0.0, 0.02, 4).factor, "");
}

TEST(LinearTicks, AreReadableForEveryRange) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-20, 20), mantissa(-10, 10);
    for (int i = 0; i < 3000; ++i) {
        const double centre = mantissa(random) * std::pow(10.0, exponent(random));
        const double half = std::abs(mantissa(random)) * std::pow(10.0, exponent(random));
        for (const int wanted : {2, 3, 5, 9, 30}) {
            SCOPED_TRACE(std::to_string(centre) + " +- " + std::to_string(half) + ", " + std::to_string(wanted));
            expect_readable(linear_ticks(centre - half, centre + half, wanted));
            if (HasFailure()) return;
        }
    }
}

TEST(LinearTicks, HaveAtMostTheWantedIntervalsUnlessTwoTicksNeedMore) {
    for (double lowest = -50.0; lowest < 50.0; lowest += 7.3)
        for (double span = 1e-6; span < 1e6; span *= 3.1)
            for (int wanted = 2; wanted < 12; ++wanted) {
                const Ticks ticks = linear_ticks(lowest, lowest + span, wanted);
                EXPECT_LE(static_cast<int>(ticks.values.size()) - 1, std::max(wanted, 4));
                for (const double v : ticks.values) {
                    EXPECT_GE(v, ticks.lowest);
                    EXPECT_LE(v, ticks.highest);
                    // Multiples of the distance of two ticks.
                    const double k = v / (ticks.values[1] - ticks.values[0]);
                    EXPECT_NEAR(k, std::round(k), 1e-6 * std::max(1.0, std::abs(k)));
                }
            }
    EXPECT_EQ(linear_ticks(-3.2, 17.9, 6).values, (std::vector<double>{0.0, 5.0, 10.0, 15.0}));
    EXPECT_EQ(linear_ticks(-20.0, 20.0, 4).labels.front(), "−20");
    EXPECT_EQ(round_step(0.2 * (1.0 + 1e-12)), 0.2);
    EXPECT_EQ(round_step(0.21), 0.5);
    EXPECT_EQ(round_step(600.0), 1000.0);
}

TEST(LinearTicks, SurviveEveryDegenerateRange) {
    const double largest = std::numeric_limits<double>::max(), smallest = std::numeric_limits<double>::denorm_min();
    for (const auto& [low, high] : std::vector<std::pair<double, double>>{{0, 0},
                                                                          {5, 5},
                                                                          {-3, -3},
                                                                          {2, 1},
                                                                          {-infinity, infinity},
                                                                          {infinity, -infinity},
                                                                          {NAN, NAN},
                                                                          {0, NAN},
                                                                          {-largest, largest},
                                                                          {0, smallest},
                                                                          {1, 1 + 1e-15},
                                                                          {1e300, 1e308}}) {
        expect_readable(linear_ticks(low, high, 5));
        expect_readable(logarithmic_ticks(low, high, 5));
    }
}

TEST(LogarithmicTicks, AreDecadesAndFillShortRanges) {
    EXPECT_EQ(logarithmic_ticks(1e-4, 1e-1, 5).labels, (std::vector<std::string>{"10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"}));
    EXPECT_EQ(logarithmic_ticks(1.0, 60.0, 5).labels, (std::vector<std::string>{"1", "2", "5", "10", "20", "50"}));
    const Ticks wide = logarithmic_ticks(1e-12, 1e12, 5);
    EXPECT_LE(wide.values.size(), 7u);
    expect_readable(wide);
}

TEST(LogarithmicTicks, AreReadableForEveryRange) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(-15, 15), ratio(0.0, 12.0);
    for (int i = 0; i < 3000; ++i) {
        const double lowest = std::pow(10.0, exponent(random));
        SCOPED_TRACE(lowest);
        expect_readable(logarithmic_ticks(lowest, lowest * std::pow(10.0, ratio(random)), 5));
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace myo::chart
