#include "chart/decimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/not_finite.hpp"

namespace myo::chart {
namespace {

using test::nan;

Polyline long_curve(std::size_t count) {
    Polyline curve;
    for (std::size_t i = 0; i < count; ++i) {
        curve.x.push_back(700.0 * static_cast<double>(i) / static_cast<double>(count));
        curve.y.push_back(std::sin(0.01 * static_cast<double>(i)));
    }
    return curve;
}

TEST(Decimate, KeepsShortCurvesAsTheyAre) {
    const Polyline curve = long_curve(300);
    EXPECT_EQ(decimate(curve).y, curve.y);
}

TEST(Decimate, KeepsExtremesEndsAndOrder) {
    Polyline curve = long_curve(200000);
    curve.y[123457] = 9.0;
    curve.y[77777] = -9.0;
    const Polyline thin = decimate(curve, 1.0);
    EXPECT_LE(thin.x.size(), 4u * 700u);
    EXPECT_GE(thin.x.size(), 700u);
    EXPECT_EQ(*std::max_element(thin.y.begin(), thin.y.end()), 9.0);
    EXPECT_EQ(*std::min_element(thin.y.begin(), thin.y.end()), -9.0);
    EXPECT_TRUE(std::is_sorted(thin.x.begin(), thin.x.end()));
    EXPECT_EQ(thin.y.front(), curve.y.front());
    EXPECT_EQ(thin.y.back(), curve.y.back());
}

TEST(Decimate, KeepsGaps) {
    Polyline curve = long_curve(10000);
    for (std::size_t i = 4000; i < 5000; ++i) curve.y[i] = nan;
    const Polyline thin = decimate(curve);
    EXPECT_EQ(std::count_if(thin.y.begin(), thin.y.end(), [](double v) { return std::isnan(v); }), 1);
    for (std::size_t i = 0; i < thin.x.size(); ++i)
        EXPECT_TRUE(std::isnan(thin.y[i]) || thin.x[i] < curve.x[4000] || thin.x[i] >= curve.x[5000]);
}

TEST(Decimate, NothingIsLeftOfACurveOfGaps) {
    const Polyline gaps{std::vector<double>(1000, nan), std::vector<double>(1000, nan)};
    EXPECT_TRUE(decimate(gaps).x.empty());
}

}  // namespace
}  // namespace myo::chart
