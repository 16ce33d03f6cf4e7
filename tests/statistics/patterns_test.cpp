#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "noise.hpp"
#include "statistics/correlates.hpp"
#include "statistics/residual_patterns.hpp"

namespace myo::statistics {
namespace {

using test::autoregressive;
using test::make_layout;
using test::signal;
using test::white;

TEST(ResidualPatterns, RebuildTheResidual) {
    std::mt19937 random(1);
    const ResidualLayout layout = make_layout({.trials = 2, .markers = 2, .samples = 40});
    const Eigen::VectorXd r = white(layout.size(), random);
    const std::vector<ResidualPatterns> trials = residual_patterns(r, layout, 6);
    ASSERT_EQ(trials.size(), 2U);
    Eigen::VectorXd rebuilt = Eigen::VectorXd::Zero(layout.size());
    for (const ResidualSeries& series : layout.series)
        for (const ResidualMode& mode : trials[static_cast<std::size_t>(series.trial)].modes)
            rebuilt.segment(series.begin, series.size()) += mode.pattern(series.axis, series.marker) * mode.course;
    EXPECT_LT((rebuilt - r).norm(), 1e-10);
    double shares = 0.0;
    for (const ResidualMode& mode : trials[1].modes) {
        shares += mode.share;
        EXPECT_NEAR(mode.pattern.norm(), std::sqrt(6.0), 1e-12);
        EXPECT_GT(mode.pattern.maxCoeff(), -mode.pattern.minCoeff());
    }
    EXPECT_NEAR(shares, 1.0, 1e-12);
    EXPECT_NEAR(trials[0].time_s(39), 0.39, 1e-12);
}

TEST(ResidualPatterns, FindAPatternInNoise) {
    std::mt19937 random(2);
    ResidualLayout layout = make_layout({.trials = 1, .markers = 4, .samples = 200, .gaps = 0.05});
    for (ResidualSeries& series : layout.series) series.marker *= 3;  // not numbered through
    const auto shape = [](const ResidualSeries& series) { return series.axis == 2 ? 1.0 + series.marker : 0.0; };
    const auto course = [](double t) { return std::sin(2.0 * std::numbers::pi * 3.0 * t); };
    const Eigen::VectorXd r = white(layout.size(), random) +
                              signal(layout, [&](const ResidualSeries& s, double t) { return shape(s) * course(t); });
    const ResidualPatterns patterns = residual_patterns(r, layout)[0];
    EXPECT_EQ(patterns.markers, (std::vector<int>{0, 3, 6, 9}));
    ASSERT_EQ(patterns.modes.size(), 3U);
    EXPECT_GT(patterns.modes[0].share, 10.0 * patterns.modes[1].share);
    const Eigen::Matrix3Xd& pattern = patterns.modes[0].pattern;
    for (int m = 0; m < 4; ++m) EXPECT_NEAR(pattern(2, m) / pattern(2, 3), (1.0 + 3.0 * m) / 10.0, 0.04);
    EXPECT_LT(pattern.topRows(2).cwiseAbs().maxCoeff(), 0.05 * pattern(2, 3));
    EXPECT_TRUE(residual_patterns(Eigen::VectorXd(), {}).empty());
    EXPECT_TRUE(residual_patterns(Eigen::VectorXd::Zero(layout.size()), layout)[0].modes.empty());
}

TEST(Correlates, FindWhatTheForceFollows) {
    std::mt19937 random(3);
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(400, 0.0, 4.0);
    const Eigen::VectorXd position = (-0.4 * time.array()).exp() * (12.0 * time.array()).cos();
    const Eigen::VectorXd velocity = (-0.4 * time.array()).exp() * (12.0 * time.array()).sin() * -12.0;
    const Eigen::VectorXd quadratic = velocity.cwiseProduct(velocity.cwiseAbs());
    Eigen::VectorXd force = -0.02 * quadratic + 0.2 * white(400, random);
    force.segment(100, 20).setConstant(std::numeric_limits<double>::quiet_NaN());
    const std::vector<Correlate> found = correlates(force, {{"time", time},
                                                            {"position", position},
                                                            {"velocity", velocity},
                                                            {"|v| v", quadratic},
                                                            {"constant", Eigen::VectorXd::Constant(400, 0.3)}});
    ASSERT_EQ(found.size(), 5U);
    EXPECT_EQ(found[0].name, "|v| v");
    EXPECT_LT(found[0].correlation, -0.9);
    EXPECT_LT(found[0].p, 1e-6);
    EXPECT_LT(found[0].effective_samples, 300.0);
    EXPECT_EQ(found[1].name, "velocity");
    EXPECT_EQ(found[4].name, "constant");
    EXPECT_EQ(found[4].correlation, 0.0);
    EXPECT_EQ(found[4].p, 1.0);
    // Plain coefficient of the samples that are known.
    double xy = 0.0, xx = 0.0, yy = 0.0, mean_x = 0.0, mean_y = 0.0;
    for (Eigen::Index t = 0; t < 400; ++t)
        if (!std::isnan(force(t))) mean_x += force(t) / 380.0, mean_y += quadratic(t) / 380.0;
    for (Eigen::Index t = 0; t < 400; ++t) {
        if (std::isnan(force(t))) continue;
        xy += (force(t) - mean_x) * (quadratic(t) - mean_y);
        xx += std::pow(force(t) - mean_x, 2);
        yy += std::pow(quadratic(t) - mean_y, 2);
    }
    EXPECT_NEAR(found[0].correlation, xy / std::sqrt(xx * yy), 1e-12);
}

TEST(Correlates, SlowCoursesDoNotCorrelateByChance) {
    std::mt19937 random(4);
    constexpr int draws = 400;
    double alarms = 0.0;
    for (int k = 0; k < draws; ++k)
        alarms += (correlates(autoregressive(500, 0.9, random), {{"other", autoregressive(500, 0.9, random)}})[0].p <
                   0.05) /
                  static_cast<double>(draws);
    EXPECT_NEAR(alarms, 0.05, 0.04);  // without the correction about 0.5
    RecordProperty("false_alarms_of_0.05", std::to_string(alarms));
    EXPECT_EQ(correlates(Eigen::VectorXd::Ones(10), {{"t", Eigen::VectorXd::LinSpaced(10, 0.0, 1.0)}})[0].p, 1.0);
}

}  // namespace
}  // namespace myo::statistics
