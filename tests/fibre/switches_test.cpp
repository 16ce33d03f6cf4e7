#include "fibre/switches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace myo::fibre {
namespace {

constexpr double h = 0.005;

double integral(const Signal& s, double from, double to) {
    double sum = 0.0;
    const int parts = 200000;
    for (int k = 0; k < parts; ++k) sum += s.value(from + (to - from) * (k + 0.5) / parts);
    return sum * (to - from) / parts;
}

Signal at_1_kHz(double end_s, const auto& value) {
    Signal log{{}, {}};
    for (int k = 0; 1e-3 * k < end_s + 1e-9; ++k) {
        log.times_s.push_back(1e-3 * k);
        log.values.push_back(value(1e-3 * k));
    }
    return log;
}

TEST(Switches, ARiseWithinAStepIsAJumpAtItsTime) {
    const Signal jumped = with_switches_as_jumps({{0.0, 0.3, 0.300001}, {1.0, 1.0, 0.85}}, h);
    EXPECT_EQ(jumped.jumps(), std::vector<double>{0.3});
    EXPECT_EQ(jumped.value_before(0.3), 1.0);
    EXPECT_EQ(jumped.value(0.3), 0.85);
    // A millisecond's rise stands for its middle.
    const Signal slower = with_switches_as_jumps({{0.0, 0.3, 0.301}, {1.0, 1.0, 0.85}}, h);
    ASSERT_EQ(slower.jumps().size(), 1u);
    EXPECT_NEAR(slower.jumps().front(), 0.3005, 1e-9);
}

TEST(Switches, LeaveTheSignalItsIntegral) {
    const Signal uneven{{0.0, 0.1, 0.101, 0.102, 0.103, 0.2, 0.3}, {1.0, 1.0, 0.98, 0.87, 0.85, 0.8, 0.9}};
    const Signal jumped = with_switches_as_jumps(uneven, h);
    ASSERT_EQ(jumped.jumps().size(), 1u);
    EXPECT_NEAR(integral(jumped, 0.0, 0.3), integral(uneven, 0.0, 0.3), 2e-6);
    for (const double t : {0.05, 0.099, 0.104, 0.15, 0.25}) EXPECT_NEAR(jumped.value(t), uneven.value(t), 1e-12) << t;
}

TEST(Switches, AreFoundInSequencesAndInAValveLog) {
    const auto valve = [](double t) { return t > 0.1004 && t < 0.1804 ? 0.85 : t > 0.2304 && t < 0.2334 ? 0.9 : 1.0; };
    const Signal jumped = with_switches_as_jumps(at_1_kHz(0.3, valve), h);
    const std::vector<double> expected{0.1005, 0.1805, 0.2305, 0.2335};  // the last two lie within a step
    ASSERT_EQ(jumped.jumps().size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(jumped.jumps()[k], expected[k], 1e-9);
    EXPECT_EQ(jumped.value(0.15), 0.85);
    EXPECT_EQ(jumped.value(0.232), 0.9);
    EXPECT_EQ(jumped.value(0.3), 1.0);
    for (std::size_t k = 1; k < jumped.times_s.size(); ++k) EXPECT_GE(jumped.times_s[k], jumped.times_s[k - 1]);
}

TEST(Switches, AreFoundUnderAPressureSensorsNoise) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 5e-4);
    const Signal jumped = with_switches_as_jumps(
        at_1_kHz(0.4, [&](double t) { return (t < 0.2 ? 1.0 : 0.85) + noise(random); }), h);
    const std::vector<double> jumps = jumped.jumps();
    EXPECT_TRUE(std::any_of(jumps.begin(), jumps.end(), [](double t) { return std::abs(t - 0.1995) < 2e-4; }));
    EXPECT_LT(jumps.size(), 5u);
}

TEST(Switches, AreNotSmoothCoursesRampsOfAStepOrNoise) {
    const Signal smooth = at_1_kHz(1.0, [](double t) { return 1.0 + 0.2 * std::sin(30.0 * t); });
    EXPECT_EQ(with_switches_as_jumps(smooth, h), smooth);
    const Signal ramp{{0.0, 0.1, 0.1 + h, 0.2}, {1.0, 1.0, 0.8, 0.8}};
    EXPECT_EQ(with_switches_as_jumps(ramp, h), ramp);
    const Signal fast_ramp = at_1_kHz(0.3,
                                      [](double t) { return 1.0 - 0.2 * std::clamp((t - 0.1) / 0.008, 0.0, 1.0); });
    EXPECT_EQ(with_switches_as_jumps(fast_ramp, h), fast_ramp);
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0.0, 0.01);
    const Signal noise = at_1_kHz(2.0, [&](double) { return 1.0 + normal(random); });
    EXPECT_LT(with_switches_as_jumps(noise, h).jumps().size(), 0.05 * 2.0 / h);  // steps beside those of the run
    EXPECT_EQ(with_switches_as_jumps(Signal::step(0.1, 1.0, 0.8), h), Signal::step(0.1, 1.0, 0.8));
    EXPECT_EQ(with_switches_as_jumps(Signal::constant(0.8), h), Signal::constant(0.8));
}

}  // namespace
}  // namespace myo::fibre
