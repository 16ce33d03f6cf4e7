#include "plot/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace myo::ui {
namespace {

TEST(Ticks, AreNiceMultiplesInsideTheRange) {
    const plot::Ticks ticks = plot::make_ticks({-3.2, 17.9}, 6);
    EXPECT_EQ(ticks.step, 5.0);
    EXPECT_EQ(ticks.values, (std::vector<double>{0.0, 5.0, 10.0, 15.0}));
}

TEST(Ticks, NeverMoreThanAskedForNorTooFew) {
    for (double lowest = -50.0; lowest < 50.0; lowest += 7.3) {
        for (double span = 1e-6; span < 1e6; span *= 3.1) {
            for (int most = 2; most < 12; ++most) {
                const plot::Ticks ticks = plot::make_ticks({lowest, lowest + span}, most);
                EXPECT_LE(static_cast<int>(ticks.values.size()), most);
                for (const double v : ticks.values) {
                    EXPECT_GE(v, lowest - 1e-6 * span);
                    EXPECT_LE(v, lowest + span * (1.0 + 1e-6));
                }
            }
        }
    }
}

TEST(Ticks, SurviveBadRanges) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(plot::make_ticks({1.0, 1.0}, 5).values.empty());
    EXPECT_TRUE(plot::make_ticks({2.0, 1.0}, 5).values.empty());
    EXPECT_TRUE(plot::make_ticks({nan, 1.0}, 5).values.empty());
    EXPECT_TRUE(plot::make_ticks({0.0, std::numeric_limits<double>::infinity()}, 5).values.empty());
    EXPECT_TRUE(plot::make_ticks({1e9, 1e9 + 1e-6}, 5).values.empty());
}

TEST(Labels, DecimalsFollowTheStep) {
    EXPECT_EQ(plot::tick_label(0.30000000000000004, 0.1), "0.3");
    EXPECT_EQ(plot::tick_label(-1e-18, 0.05), "0.00");
    EXPECT_EQ(plot::tick_label(-20.0, 10.0),
              "\xe2\x88\x92"
              "20");
    EXPECT_EQ(plot::value_label(-0.0049236, 3),
              "\xe2\x88\x92"
              "0.00492");
    EXPECT_EQ(plot::value_label(263824.0, 3), "263824");
    EXPECT_EQ(plot::value_label(-0.0, 3), "0.00");
    EXPECT_EQ(plot::value_label(std::nan(""), 3), "\xe2\x80\x93");
}

TEST(Ranges, IgnoreGapsAndGetAnExtent) {
    const double values[] = {3.0, std::nan(""), -1.0, std::numeric_limits<double>::infinity()};
    EXPECT_EQ(plot::range_of({values}, {4}), (plot::Range{-1.0, 3.0}));
    EXPECT_EQ(plot::range_of({}, {}), plot::Range{});
    EXPECT_GT(plot::padded({2.0, 2.0}, 0.1).span(), 0.0);
    const plot::Range zoom = plot::zoomed({0.0, 10.0}, 2.0, 0.5);
    EXPECT_EQ(zoom, (plot::Range{1.0, 6.0}));
    EXPECT_DOUBLE_EQ(plot::from_pixel({-1.0, 3.0}, plot::to_pixel({-1.0, 3.0}, 0.7, 20.0, 300.0), 20.0, 300.0), 0.7);
}

}  // namespace
}  // namespace myo::ui
