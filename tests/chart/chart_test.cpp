#include "chart/svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo::chart {
namespace {

using test::infinity;
using test::nan;

void expect_sound(const std::string& figure) {
    EXPECT_EQ(test::markup_fault(figure), "");
    EXPECT_FALSE(test::holds_non_number(figure));
    EXPECT_EQ(figure.find(" id="), std::string::npos);  // two figures of one page could clash
    EXPECT_EQ(figure.substr(0, 4), "<svg");
    EXPECT_EQ(figure.substr(0, figure.find('>')).find(" width="), std::string::npos);  // fills its column
}

Chart curve_of(std::vector<double> x, std::vector<double> y) {
    return {.title = "t", .x = {"time", "s"}, .panels = {{.y = {"z", "mm"}, .series = {{"simulated", x, y}}}}};
}

TEST(LineChart, DrawsAPointWhereTheScaleSaysItIs) {
    Chart chart = curve_of({0, 1, 2}, {0, 5, 10});
    chart.panels[0].y.lowest = 0.0;
    chart.panels[0].y.highest = 10.0;
    const std::string figure = svg(chart);
    expect_sound(figure);
    // The panel is 240 px high: the middle sample lies half way between the ends.
    const std::size_t path = figure.find("<path d=\"M");
    double x0, y0, x1, y1, x2, y2;
    ASSERT_EQ(std::sscanf(figure.c_str() + path, "<path d=\"M%lf %lfL%lf %lfL%lf %lf", &x0, &y0, &x1, &y1, &x2, &y2),
              6);
    EXPECT_NEAR(y0 - y2, 240.0, 0.011);
    EXPECT_NEAR(y1, 0.5 * (y0 + y2), 0.011);
    EXPECT_NEAR(x1, 0.5 * (x0 + x2), 0.011);
    EXPECT_NE(figure.find("time [s]"), std::string::npos);
    EXPECT_NE(figure.find("z [mm]"), std::string::npos);
}

TEST(LineChart, BreaksAtNanAndShowsLonelySamples) {
    const std::string figure = svg(curve_of({0, 1, 2, 3, 4, 5, 6}, {1, 2, nan, 3, nan, 2, 1}));
    expect_sound(figure);
    const std::size_t begin = figure.find("<path d=\"M");
    const std::string line = figure.substr(begin, figure.find("/>", begin) - begin);
    EXPECT_EQ(test::count_of(line, "M"), 2);  // two runs of two samples
    EXPECT_EQ(test::count_of(line, "L"), 2);
    EXPECT_EQ(test::count_of(figure, "h0"), 1);  // and a dot for the sample between two gaps
}

TEST(LineChart, WritesOnlyNumbersWhateverIsInTheData) {
    const std::vector<double> odd = {nan, infinity, -infinity, 0.0, 1e308, -1e308, 5e-324, 1.0};
    const std::vector<double> x = {0, 1, 2, 3, 4, nan, infinity, 7};
    for (const bool logarithmic : {false, true})
        for (const SeriesStyle style :
             {SeriesStyle::line, SeriesStyle::dots, SeriesStyle::dashed, SeriesStyle::line_and_dots}) {
            Chart chart = curve_of(x, odd);
            chart.panels[0].series[0].style = style;
            chart.panels[0].series[0].half_width = {1, nan, 3, infinity, 5, 1, 1, 1};
            chart.panels[0].y.logarithmic = chart.x.logarithmic = logarithmic;
            chart.panels[0].horizontal = {{nan, "a"}, {infinity, "b"}, {0.5, "c"}};
            chart.panels[0].vertical = {{nan, "a"}, {-infinity, "b"}, {3, "c"}};
            chart.panels[0].spans = {{nan, 2, "a"}, {-infinity, infinity, "b"}, {2, 1, "c"}};
            expect_sound(svg(chart));
            chart.x.lowest = nan;
            chart.panels[0].y.highest = infinity;
            expect_sound(svg(chart));
        }
    for (const auto& only : std::vector<std::vector<double>>{{}, {nan, nan}, {infinity}, {3, 3, 3}}) {
        std::vector<double> steps(only.size());
        std::iota(steps.begin(), steps.end(), 0.0);
        expect_sound(svg(curve_of(steps, only)));
    }
    expect_sound(svg(Chart{}));
}

TEST(LineChart, EscapesEveryWord) {
    Chart chart = curve_of({0, 1}, {0, 1});
    chart.title = chart.x.label = chart.x.unit = "<&\"'>\x01\xFF";
    chart.panels[0].y.label = chart.panels[0].series[0].name = chart.title;
    chart.panels[0].series.push_back({"b<", {0, 1}, {1, 0}});
    chart.panels[0].vertical = {{0.5, "</svg>"}};
    chart.panels[0].horizontal = {{0.5, "</svg>"}};
    chart.panels[0].spans = {{0.2, 0.4, "</svg>"}};
    expect_sound(svg(chart));
}

TEST(LineChart, OneNameHasOneColourInAllPanels) {
    Chart chart = curve_of({0, 1}, {0, 1});
    chart.panels[0].series.push_back({"measured", {0, 1}, {0, 1}, SeriesStyle::dots});
    chart.panels.push_back({.y = {"residual", "mm"}, .series = {{"measured", {0, 1}, {0, 1}}}, .height_px = 90});
    const std::string figure = svg(chart);
    expect_sound(figure);
    EXPECT_EQ(test::count_of(figure, "stroke=\"#0072b2\""), 2);  // curve and legend of "simulated"
    EXPECT_EQ(test::count_of(figure, "stroke=\"#d55e00\""), 3);  // dots, legend, residual
    EXPECT_EQ(test::count_of(figure, ">measured</text>"), 1);
    EXPECT_EQ(test::count_of(figure, "time [s]"), 1);
}

TEST(LineChart, IsTheSameTextEachTimeAndShortForLongTraces) {
    std::vector<double> t(500000), z(500000);
    for (std::size_t i = 0; i < t.size(); ++i) {
        t[i] = 1e-4 * static_cast<double>(i);
        z[i] = std::sin(40.0 * t[i]) + 0.1 * std::sin(0.7 * static_cast<double>(i));
    }
    const Chart chart = curve_of(t, z);
    const std::string figure = svg(chart);
    EXPECT_EQ(figure, svg(chart));
    EXPECT_LT(figure.size(), 150000u);
    expect_sound(figure);
}

TEST(LineChart, PutsTheScaleFactorIntoTheUnit) {
    const std::string figure = svg(curve_of({0, 1}, {0.0, 3e6}));
    EXPECT_NE(figure.find("z [10⁶ mm]"), std::string::npos);
}

TEST(BarChart, DrawsOneBarPerFiniteValue) {
    const BarChart bars{.categories = {"none", "drag <1>", "lag"},
                        .y = {"rms", "mm"},
                        .groups = {{"before", {3.0, nan, 1.0}}, {"after", {1.0, 0.5, infinity}}}};
    const std::string figure = svg(chart_of(bars));
    expect_sound(figure);
    EXPECT_EQ(test::count_of(figure, "fill=\"#0072b2\""), 2 + 1);  // and one in the legend
    EXPECT_EQ(test::count_of(figure, "fill=\"#d55e00\""), 2 + 1);
    expect_sound(svg(chart_of(BarChart{})));
    expect_sound(svg(
        chart_of(BarChart{.categories = {"a"}, .y = {.label = "x", .logarithmic = true}, .groups = {{"", {-1.0}}}})));
}

TEST(Histogram, CountsEveryFiniteSampleOnce) {
    std::vector<double> samples = {nan, infinity};
    for (int i = 0; i < 1000; ++i) samples.push_back(std::sin(i) * std::sin(3 * i));
    for (const int bins : {0, 3, 20}) {
        Histogram histogram = histogram_of(samples, bins);
        histogram.x = {"shape", ""};
        ASSERT_EQ(histogram.edges.size(), histogram.counts.size() + 1);
        EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0), 1000.0);
        for (std::size_t b = 0; b < histogram.counts.size(); ++b) {
            const auto inside = [&](double v) {
                return v >= histogram.edges[b] - 1e-12 && v < histogram.edges[b + 1] - 1e-12;
            };
            EXPECT_EQ(histogram.counts[b], static_cast<double>(std::count_if(samples.begin(), samples.end(), inside)));
        }
        expect_sound(svg(chart_of(histogram)));
    }
    EXPECT_TRUE(histogram_of({nan}).counts.empty());
    EXPECT_EQ(histogram_of({2.0, 2.0}).counts.size(), histogram_of({2.0, 2.0}).edges.size() - 1);
    expect_sound(svg(chart_of(Histogram{})));
}

TEST(ErrorBarChart, ShowsEveryRow) {
    const ErrorBarChart rows{
        .x = {"relative error", "%"},
        .rows = {{"Young's modulus", 1.0, 0.5, 1.5, 0.0}, {"damping", nan}, {"<third>", 2.0, -infinity, infinity}},
        .reference_name = "truth"};
    const std::string figure = svg(chart_of(rows));
    expect_sound(figure);
    EXPECT_EQ(test::count_of(figure, "h0"), 2 + 1);  // two values and the legend
    EXPECT_EQ(test::count_of(figure, "no value"), 1);
    expect_sound(svg(chart_of(ErrorBarChart{})));
}

}  // namespace
}  // namespace myo::chart
