#include "statistics/independence_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "noise.hpp"

namespace myo::statistics {
namespace {

using test::autoregressive;
using test::make_layout;
using test::signal;
using test::white;

/// A beam that swings down at 4 Hz: the markers' shares of a motion along y and z.
double swing(const ResidualSeries& series, double t) {
    return (series.axis == 0   ? 0.1
            : series.axis == 1 ? 0.5
                               : 1.0) *
           (1.0 + series.marker) * std::exp(-2.0 * t) * std::cos(8.0 * M_PI * t);
}

Eigen::VectorXd of_rms(Eigen::VectorXd values, double rms) {
    return values * (rms * std::sqrt(static_cast<double>(values.size())) / values.norm());
}

/// Wander of a camera system: slow, each coordinate of each marker by itself. The chances are even, as those of a test
/// have to be. (Where it is so slow that a trial holds few turns of it, shifting it round the end makes steps, and much
/// of it does not vary: it is taken for wander less often.)
TEST(IndependenceTest, HoldsItsRateForWander) {
    const ResidualLayout layout = make_layout({.markers = 6});
    std::mt19937 random(5);
    constexpr int draws = 200;
    for (const double a : {0.0, 0.6, 0.8}) {
        int below = 0, wander = 0;
        for (int k = 0; k < draws; ++k) {
            const Eigen::VectorXd r = autoregressive(layout, a, random) + white(layout.size(), random);
            const IndependenceTest test = independence_test(r, layout, 99, static_cast<unsigned>(k));
            below += test.p < 0.1 ? 1 : 0;
            wander += test.is_drift() ? 1 : 0;
        }
        EXPECT_NEAR(below, 0.1 * draws, 4.0 * std::sqrt(0.09 * draws)) << a;
        EXPECT_GT(wander, (a > 0.0 ? 0.85 : 0.0) * draws) << a;
    }
}

/// A swing of half the noise in all markers is a force on the body, wander beside it or not, and with gaps.
TEST(IndependenceTest, SeesWhatMarkersShare) {
    std::mt19937 random(6);
    for (const double gaps : {0.0, 0.3})
        for (int k = 0; k < 40; ++k) {
            const ResidualLayout layout = make_layout(
                {.markers = 6, .gaps = gaps, .seed = static_cast<unsigned>(k + 1)});
            const Eigen::VectorXd shared = of_rms(signal(layout, swing), 0.5);
            const IndependenceTest alone = independence_test(shared + white(layout.size(), random), layout);
            EXPECT_LT(alone.p, 2e-3);
            EXPECT_FALSE(alone.is_drift());
            if (gaps > 0.0) continue;
            EXPECT_FALSE(independence_test(
                             2.0 * shared + autoregressive(layout, 0.8, random) + white(layout.size(), random), layout)
                             .is_drift());
        }
}

/// Sagging and creeping are slow, and a wrong scale does not vary at all: no time shift tells these from wander, which
/// they are not.
TEST(IndependenceTest, TakesNothingSlowThatIsSharedForWander) {
    std::mt19937 random(9);
    const ResidualLayout layout = make_layout({.markers = 6});
    const auto slow = [&](double time_s) {
        return of_rms(signal(layout,
                             [&](const ResidualSeries& series, double t) {
                                 return (series.axis + 1.0) * (1.0 + series.marker) * (1.0 - std::exp(-t / time_s));
                             }),
                      1.0);
    };
    for (int k = 0; k < 40; ++k)
        for (const double time_s : {0.02, 0.3, 3.0})
            EXPECT_FALSE(independence_test(slow(time_s) + white(layout.size(), random), layout).is_drift()) << time_s;
}

/// A marker that slips is none of the body's doing, but no wander either.
TEST(IndependenceTest, KnowsOneMarkerFromAll) {
    std::mt19937 random(7);
    const ResidualLayout layout = make_layout({.markers = 6});
    for (int k = 0; k < 20; ++k) {
        const Eigen::VectorXd slip = signal(
            layout, [](const ResidualSeries& series, double t) { return series.marker == 2 && t > 0.7 ? 5.0 : 0.0; });
        const IndependenceTest test = independence_test(slip + white(layout.size(), random), layout);
        EXPECT_LT(test.typical_share, 0.1);
        EXPECT_FALSE(test.is_drift());
    }
}

TEST(IndependenceTest, NeedsThreeMarkers) {
    std::mt19937 random(8);
    const ResidualLayout layout = make_layout({.markers = 2});
    EXPECT_EQ(independence_test(autoregressive(layout, 0.8, random), layout).p, 0.0);
    EXPECT_EQ(independence_test(Eigen::VectorXd(0), ResidualLayout{}).p, 0.0);
}

}  // namespace
}  // namespace myo::statistics
