#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "chart/chart.hpp"
#include "chart/decimate.hpp"
#include "support/not_finite.hpp"

namespace myo::chart::chart_values_test {
namespace {

using test::infinity;
using test::nan;

TEST(BarGroups, StandSideBySideAroundTheirCategory) {
    for (const std::size_t groups : {1u, 2u, 3u}) {
        BarChart bars{.categories = std::vector<std::string>(20, "c"), .width_px = 760.0};
        for (std::size_t g = 0; g < groups; ++g) bars.groups.push_back({"g", std::vector<double>(20, 1.0)});
        const Chart chart = chart_of(bars);
        ASSERT_EQ(chart.panels.size(), 1u);
        const std::vector<Series>& series = chart.panels[0].series;
        ASSERT_EQ(series.size(), groups);
        for (std::size_t i = 0; i < 20; ++i) {
            const double from = series.front().ends[i].lowest, to = series.back().ends[i].highest;
            EXPECT_NEAR(0.5 * (from + to), static_cast<double>(i), 1e-12);
            EXPECT_NEAR(to - from, 0.72, 1e-12) << "the rest separates categories";
            for (std::size_t g = 0; g < groups; ++g) {
                EXPECT_NEAR(series[g].x[i], 0.5 * (series[g].ends[i].lowest + series[g].ends[i].highest), 1e-12);
                if (g == 0) continue;
                EXPECT_NEAR(series[g].ends[i].lowest, series[g - 1].ends[i].highest, 1e-12);
            }
        }
        EXPECT_TRUE(chart.panels[0].y.include_zero);
    }
}

TEST(BarGroups, OfFewCategoriesAreAtMost56PixelsWide) {
    for (const double width_px : {100.0, 760.0}) {
        const Chart chart = chart_of(
            BarChart{.categories = {"a", "b"}, .groups = {{"", {1, 2}}}, .width_px = width_px});
        const Range bar = chart.panels[0].series[0].ends[1];
        // A category takes half of the width.
        EXPECT_NEAR(bar.span() * 0.5 * width_px, std::min(56.0, 0.72 * 0.5 * width_px), 1e-9);
    }
    EXPECT_FALSE(chart_of(BarChart{.y = {.logarithmic = true}}).panels[0].y.include_zero);
}

TEST(HistogramBars, LieOnTheirBins) {
    const Chart chart = chart_of(Histogram{.edges = {0.0, 1.0, 4.0}, .counts = {7.0, 2.0}});
    const Series& bars = chart.panels[0].series[0];
    EXPECT_EQ(bars.x, (std::vector<double>{0.5, 2.5}));
    EXPECT_EQ(bars.y, (std::vector<double>{7.0, 2.0}));
    EXPECT_EQ(bars.ends, (std::vector<Range>{{0.0, 1.0}, {1.0, 4.0}}));
    EXPECT_TRUE(chart.panels[0].y.include_zero);
}

TEST(HistogramBins, FollowTheSpreadOfTheSamples) {
    // Evenly spaced in [0, 1], n samples have an interquartile range of a half: the rule wants a width of n^(-1/3), a
    // little less than 0.1 and 0.034 here. Round widths are 0.1 and 0.05.
    for (const auto& [n, bins] : {std::pair{1000, 10u}, {27000, 20u}}) {
        std::vector<double> samples;
        for (int i = 0; i <= n; ++i) samples.push_back(static_cast<double>(i) / n);
        EXPECT_EQ(histogram_of(samples).counts.size(), bins) << n;
    }
    EXPECT_EQ(histogram_of({0.0, 0.3, 0.7, 1.0}).counts.size(), 5u) << "at least";
    // Without a spread the rule has no width, and with a tiny one it would have millions of bins.
    std::vector<double> outlier(1000, 0.0);
    outlier.push_back(1.0);
    EXPECT_EQ(histogram_of(outlier).counts.size(), 10u);
    for (std::size_t i = 0; i < 1000; ++i) outlier[i] = 1e-9 * static_cast<double>(i);
    EXPECT_EQ(histogram_of(outlier).counts.size(), 50u) << "sixty wanted, 0.02 wide";
}

TEST(HistogramBins, HoldEdgesInTheUpperBinAndOmitHugeValues) {
    const Histogram histogram = histogram_of({0.0, 0.1, 0.2, 0.3, 0.7, 1.0, 1e151, -1e151, nan, infinity}, 10);
    ASSERT_EQ(histogram.counts.size(), 10u);
    EXPECT_EQ(histogram.edges.front(), 0.0);
    EXPECT_NEAR(histogram.edges.back(), 1.0, 1e-12);
    // 0.1, 0.2 and 0.3 lie on edges up to rounding, the last one in the last bin.
    EXPECT_EQ(histogram.counts, (std::vector<double>{1, 1, 1, 1, 0, 0, 0, 1, 0, 1}));
    EXPECT_TRUE(histogram_of({}).edges.empty());
    EXPECT_TRUE(histogram_of({}).counts.empty());
    const Histogram one = histogram_of({-3.0});
    EXPECT_EQ(std::accumulate(one.counts.begin(), one.counts.end(), 0.0), 1.0);
    EXPECT_LE(one.edges.front(), -3.0);
    EXPECT_GE(one.edges.back(), -3.0);
}

TEST(HistogramBins, AreEqualAndRound) {
    const Histogram histogram = histogram_of({-7.3, 12.9, 3.0}, 5);
    // 20.2 over five is 4.04: the next round width is 5.
    EXPECT_EQ(histogram.edges, (std::vector<double>{-10.0, -5.0, 0.0, 5.0, 10.0, 15.0}));
    EXPECT_EQ(histogram.counts, (std::vector<double>{1, 0, 1, 0, 1}));
}

TEST(ErrorBars, HaveTheirFirstRowAtTheTop) {
    const Chart chart = chart_of(ErrorBarChart{
        .rows = {{"first", 1.0, 0.5, 1.5}, {"second", 2.0, 1.0, 3.0, 2.5}, {"third", 3.0}}, .reference_name = "truth"});
    const Panel& panel = chart.panels[0];
    EXPECT_EQ(panel.y.categories, (std::vector<std::string>{"third", "second", "first"}));
    const Series &estimates = panel.series[0], &references = panel.series[1];
    EXPECT_EQ(estimates.x, (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(estimates.y, (std::vector<double>{2.0, 1.0, 0.0}));
    EXPECT_EQ(estimates.ends[1], (Range{1.0, 3.0}));
    EXPECT_TRUE(std::isnan(estimates.ends[2].lowest));
    EXPECT_EQ(references.x, (std::vector<double>{2.5}));
    EXPECT_EQ(references.y, (std::vector<double>{1.0})) << "in the row of its estimate";
    EXPECT_EQ(estimates.name, "estimate");
    EXPECT_EQ(references.name, "truth");
    EXPECT_DOUBLE_EQ(panel.height_px, 3.0 * chart_of(ErrorBarChart{}).panels[0].height_px) << "a row has room always";
}

TEST(ErrorBars, HaveALegendOnlyWithReferences) {
    for (const bool named : {false, true})
        for (const bool given : {false, true}) {
            ErrorBarChart rows{.rows = {{"a", 1.0}}, .reference_name = named ? "truth" : ""};
            if (given) rows.rows[0].reference = 1.0;
            const Panel panel = chart_of(rows).panels[0];
            EXPECT_EQ(panel.series[0].name.empty(), !(named && given));
            EXPECT_EQ(panel.series[1].name.empty(), !(named && given));
        }
}

TEST(ErrorBars, SayWhyAnEstimateIsNotSeen) {
    struct Seen {
        double value;
        bool logarithmic;
        const char* remark;
    };
    for (const Seen& one : {Seen{2.0, false, ""},
                            {1.0, false, ""},
                            {10.0, false, ""},
                            {0.99, false, "outside the axis"},
                            {10.01, false, "outside the axis"},
                            {0.0, false, "outside the axis"},
                            {0.0, true, "no value"},
                            {-5.0, true, "no value"},
                            {nan, false, "no value"},
                            {-infinity, false, "no value"}}) {
        const ErrorBarChart rows{.x = {.lowest = 1.0, .highest = 10.0, .logarithmic = one.logarithmic},
                                 .rows = {{"above", 5.0}, {"row", one.value}}};
        const std::vector<Note> notes = chart_of(rows).panels[0].notes;
        ASSERT_EQ(notes.size(), *one.remark == '\0' ? 0u : 1u) << one.value;
        if (notes.empty()) continue;
        EXPECT_EQ(notes[0].text, one.remark) << one.value;
        EXPECT_EQ(notes[0].y, 0.0) << "beside the second row";
    }
}

TEST(Decimation, KeepsAtMostFourPointsOfAColumnInTheirOrder) {
    Polyline curve;
    // One column of 1 px: down, up, down again.
    for (int i = 0; i < 500; ++i) {
        curve.x.push_back(10.0 + i / 500.0);
        curve.y.push_back(i == 100 ? -5.0 : i == 300 ? 8.0 : 0.001 * i);
    }
    const Polyline thin = decimate(curve, 1.0);
    EXPECT_EQ(thin.y, (std::vector<double>{0.0, -5.0, 8.0, 0.001 * 499}));
    EXPECT_EQ(thin.x, (std::vector<double>{curve.x[0], curve.x[100], curve.x[300], curve.x[499]}));
    // Monotonic: the ends are the extremes.
    curve.y[100] = 0.1, curve.y[300] = 0.3;
    EXPECT_EQ(decimate(curve, 1.0).y.size(), 2u);
    EXPECT_EQ(decimate(curve, 2.0).y.size(), 4u) << "two columns";
}

TEST(Decimation, FollowsACurveThatGoesBack) {
    Polyline curve;
    for (int turn = 0; turn < 4; ++turn)
        for (int i = 0; i < 200; ++i) {
            curve.x.push_back(turn % 2 == 0 ? 0.01 * i : 1.99 - 0.01 * i);
            curve.y.push_back(turn);
        }
    const Polyline thin = decimate(curve, 1.0);
    for (int turn = 0; turn < 4; ++turn) EXPECT_NE(std::find(thin.y.begin(), thin.y.end(), turn), thin.y.end()) << turn;
    EXPECT_TRUE(std::is_sorted(thin.y.begin(), thin.y.end()));
    EXPECT_LE(thin.x.size(), 4u * 8u);
}

TEST(Decimation, BeginsAt400Points) {
    for (const int count : {399, 400}) {
        Polyline curve;
        for (int i = 0; i < count; ++i) curve.x.push_back(0.5 * i / count), curve.y.push_back(i);
        EXPECT_EQ(decimate(curve, 1.0).x.size(), count < 400 ? 399u : 2u);
    }
}

}  // namespace
}  // namespace myo::chart::chart_values_test
