#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "chart/scale.hpp"
#include "support/not_finite.hpp"

namespace myo::chart::axis_test {
namespace {

DataRange data_of(const Axis& axis, const std::vector<double>& values) {
    DataRange data(axis);
    for (const double value : values) data.add(value);
    return data;
}

/// Range of an axis of 400 px with a tenth of padding.
Range padded(const Axis& axis, const std::vector<double>& values) {
    return plan_axis(axis, data_of(axis, values), 0.1, 0.0, 400.0, 50.0).scale.range();
}

struct PaddedCase {
    const char* name;
    Axis axis;
    std::vector<double> values;
    Range expected;
};

TEST(AxisRange, PadsFreeEndsAndKeepsZeroAndGivenOnes) {
    const double none = test::nan, endless = test::infinity;
    for (const PaddedCase& one : std::vector<PaddedCase>{
             {"free", {}, {0.0, 10.0}, {-1.0, 11.0}},
             {"one sample gets a range around it", {}, {5.0}, {4.7, 5.3}},
             {"zero only", {}, {0.0}, {-1.2, 1.2}},
             {"no data", {}, {}, {-0.1, 1.1}},
             {"gaps only", {}, {none, endless, -endless}, {-0.1, 1.1}},
             {"zero below the data", {.include_zero = true}, {2.0, 10.0}, {0.0, 11.0}},
             {"zero above the data", {.include_zero = true}, {-10.0, -2.0}, {-11.0, 0.0}},
             {"zero between", {.include_zero = true}, {-10.0, 10.0}, {-12.0, 12.0}},
             {"constant and zero", {.include_zero = true}, {4.0}, {0.0, 4.4}},
             {"zero without data", {.include_zero = true}, {}, {0.0, 1.1}},
             {"given start", {.lowest = 2.0}, {0.0, 10.0}, {2.0, 11.0}},
             {"given end", {.highest = 4.0}, {0.0, 10.0}, {-1.0, 4.0}},
             {"included values are data", {.include = {-10.0, none}}, {0.0, 10.0}, {-12.0, 12.0}}}) {
        const Range range = padded(one.axis, one.values);
        EXPECT_NEAR(range.lowest, one.expected.lowest, 1e-12) << one.name;
        EXPECT_NEAR(range.highest, one.expected.highest, 1e-12) << one.name;
    }
}

TEST(AxisRange, PadsDecadesOfALogarithmicAxis) {
    const Axis axis{.logarithmic = true};
    const DataRange data = data_of(axis, {1.0, 1000.0, 0.0, -5.0, test::nan});
    EXPECT_EQ(data.lowest, 1.0);
    EXPECT_EQ(data.highest, 1000.0);
    const PlannedAxis plan = plan_axis(axis, data, 0.1, 0.0, 360.0, 60.0);
    // Three decades and 0.3 on each side are 3.6.
    EXPECT_NEAR(plan.scale(1.0), 30.0, 1e-9);
    EXPECT_NEAR(plan.scale(1000.0), 330.0, 1e-9);
    EXPECT_NEAR(plan.scale(10.0) - plan.scale(1.0), 100.0, 1e-9);
    // One sample: a factor of two to both sides.
    const Range single = padded(axis, {5.0});
    EXPECT_NEAR(single.lowest, 2.5, 1e-12);
    EXPECT_NEAR(single.highest, 10.0, 1e-12);
    const Range given = padded({.lowest = 0.5, .highest = 20.0, .logarithmic = true}, {1.0, 10.0});
    EXPECT_NEAR(given.lowest, 0.5, 1e-12);
    EXPECT_NEAR(given.highest, 20.0, 1e-12);
    EXPECT_EQ(padded(axis, {-1.0, 0.0}), (Range{1.0, 10.0})) << "nothing that can be shown";
}

TEST(AxisRange, CategoriesIgnoreGivenRangesAndLogarithms) {
    const Axis axis{.lowest = 10.0, .highest = 20.0, .logarithmic = true, .categories = {"a", "b", "c"}};
    const PlannedAxis plan = plan_axis(axis, data_of(axis, {50.0}), 0.1, 0.0, 300.0, 10.0);
    EXPECT_EQ(plan.scale.range(), (Range{-0.5, 2.5}));
    EXPECT_FALSE(plan.scale.logarithmic);
    EXPECT_EQ(plan.ticks.values, (std::vector<double>{0.0, 1.0, 2.0}));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(plan.scale(k), 50.0 + 100.0 * k, 1e-12) << k;
}

TEST(AxisTicks, AreAsManyAsThereIsRoomForFromTwoToTenIntervals) {
    struct Room {
        double from_px, to_px;
        std::size_t ticks;
    };
    // A tick every 80 px of [0, 1]; the steps are 0.5, 0.2 and 0.1.
    for (const Room& room : {Room{0.0, 10.0, 3}, {0.0, 400.0, 6}, {400.0, 0.0, 6}, {0.0, 800.0, 11}, {0.0, 9e4, 11}}) {
        const PlannedAxis plan = plan_axis({}, data_of({}, {0.0, 1.0}), 0.0, room.from_px, room.to_px, 80.0);
        EXPECT_EQ(plan.ticks.values.size(), room.ticks) << room.from_px << " " << room.to_px;
        EXPECT_EQ(plan.scale(0.0), room.from_px);
        EXPECT_EQ(plan.scale(1.0), room.to_px);
    }
}

/// Labels that are left after thinning, one after the other.
std::string left_of(PlannedAxis plan, double needed_px) {
    const std::vector<double> before = plan.ticks.values;
    thin_labels(plan, needed_px);
    EXPECT_EQ(plan.ticks.values, before) << "ticks stay";
    std::string all;
    for (const std::string& label : plan.ticks.labels)
        if (!label.empty()) all += (all.empty() ? "" : " ") + label;
    return all;
}

TEST(ThinnedLabels, KeepEverySecondFifthOrTenth) {
    // Eleven labels, 10 px from one to the next.
    const PlannedAxis plan = plan_axis({}, data_of({}, {0.0, 1.0}), 0.0, 0.0, 100.0, 10.0);
    ASSERT_EQ(plan.ticks.values.size(), 11u);
    EXPECT_EQ(left_of(plan, 9.9), "0.0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1.0");
    EXPECT_EQ(left_of(plan, 10.1), "0.0 0.2 0.4 0.6 0.8 1.0");
    EXPECT_EQ(left_of(plan, 19.9), "0.0 0.2 0.4 0.6 0.8 1.0");
    EXPECT_EQ(left_of(plan, 20.1), "0.0 0.5 1.0");
    EXPECT_EQ(left_of(plan, 50.1), "0.0 1.0");
    EXPECT_EQ(left_of(plan, 1e6), "0.0 1.0") << "two at least";
}

TEST(ThinnedLabels, AreCountedFromZeroOrAreTheOutermost) {
    // Ticks from -0.3 to 0.4, 10 px from one to the next.
    const PlannedAxis plan = plan_axis({.lowest = -0.35, .highest = 0.45}, DataRange({}), 0.0, 0.0, 80.0, 10.0);
    ASSERT_EQ(plan.ticks.values.size(), 8u);
    EXPECT_EQ(left_of(plan, 15.0), "−0.2 0.0 0.2 0.4");
    EXPECT_EQ(left_of(plan, 25.0), "−0.3 0.4") << "zero alone gives no scale";
}

TEST(ThinnedLabels, OfDecadesAreThoseThatHaveRoomAfterTheOneBefore) {
    // Four decades of 100 px, upwards as on a vertical axis.
    const Axis axis{.logarithmic = true};
    const PlannedAxis plan = plan_axis(axis, data_of(axis, {1.0, 1000.0}), 0.0, 300.0, 0.0, 50.0);
    EXPECT_EQ(left_of(plan, 99.9), "1 10 100 1000");
    EXPECT_EQ(left_of(plan, 100.1), "1 100");
    EXPECT_EQ(left_of(plan, 250.0), "1 1000");
    EXPECT_EQ(left_of(plan, 300.1), "1");
}

TEST(AxisTitle, HasTheFactorBeforeTheUnit) {
    struct Named {
        const char *label, *unit, *factor, *title;
    };
    for (const Named& one : {Named{"z", "mm", "", "z [mm]"},
                             {"z", "mm", "10³", "z [10³ mm]"},
                             {"z", "", "10³", "z [10³]"},
                             {"", "mm", "", "[mm]"},
                             {"z", "", "", "z"},
                             {"", "", "", ""}})
        EXPECT_EQ(axis_title({.label = one.label, .unit = one.unit}, {.factor = one.factor}), one.title);
}

TEST(AxisScale, ContinuesBeyondItsEndsAndNeverInventsAPlace) {
    const Scale linear{2.0, 4.0, 100.0, 200.0}, decades{1.0, 100.0, 100.0, 200.0, true};
    EXPECT_DOUBLE_EQ(linear(6.0), 300.0);
    EXPECT_DOUBLE_EQ(linear.value(0.0), 0.0);
    EXPECT_NEAR(decades(1e4), 300.0, 1e-9);
    EXPECT_NEAR(decades.value(0.0), 0.01, 1e-12);
    for (const double value : {test::nan, test::infinity, -test::infinity}) {
        EXPECT_FALSE(std::isfinite(linear(value))) << value;
        EXPECT_FALSE(std::isfinite(decades(value))) << value;
    }
    EXPECT_FALSE(std::isfinite(decades(0.0)));
}

}  // namespace
}  // namespace myo::chart::axis_test
