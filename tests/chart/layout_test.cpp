#include "chart/layout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "chart/svg.hpp"
#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo::chart {
namespace {

using test::nan;

template <class Kind>
std::vector<Kind> marks_of(const Drawing& drawing) {
    std::vector<Kind> found;
    for (const Mark& mark : drawing.marks)
        if (const Kind* one = std::get_if<Kind>(&mark)) found.push_back(*one);
    return found;
}

Drawing drawing_of(const Chart& chart, const LayoutStyle& style = {}) {
    return draw(chart, lay_out(chart, style, print_palette(), estimated_text_width), print_palette());
}

TEST(Scale, MapsForthAndBack) {
    for (const bool logarithmic : {false, true}) {
        const Scale scale{2.0, 50.0, 300.0, 20.0, logarithmic};
        EXPECT_NEAR(scale(2.0), 300.0, 1e-12);
        EXPECT_NEAR(scale(50.0), 20.0, 1e-12);
        for (const double v : {2.0, 3.7, 10.0, 49.0}) EXPECT_NEAR(scale.value(scale(v)), v, 1e-12 * v);
        EXPECT_NEAR(scale(10.0), logarithmic ? 300.0 - 280.0 * std::log(5.0) / std::log(25.0) : 300.0 - 280.0 / 6.0,
                    1e-9);
        // Ascending, although pixels grow downwards.
        const Range half = scale.range(20.0, 160.0);
        EXPECT_LT(half.lowest, half.highest);
        EXPECT_NEAR(half.highest, 50.0, 1e-9);
    }
    EXPECT_FALSE(std::isfinite(Scale{1.0, 10.0, 0.0, 1.0, true}(-1.0)));
}

TEST(Axis, ContainsTheIncludedValuesAndFollowsAGivenRange) {
    DataRange data(Axis{});
    data.add(0.4), data.add(nan), data.add(0.6);
    const PlannedAxis wide = plan_axis({.include = {0.0, 2.0}}, data, 0.0, 0.0, 100.0, 20.0);
    EXPECT_EQ(wide.scale.range(), (Range{0.0, 2.0}));
    const PlannedAxis given = plan_axis({.lowest = 0.5, .highest = 0.55}, data, 0.1, 0.0, 100.0, 20.0);
    EXPECT_EQ(given.scale.range(), (Range{0.5, 0.55}));
    const PlannedAxis names = plan_axis({.categories = {"a", "b"}}, data, 0.1, 0.0, 100.0, 20.0);
    EXPECT_EQ(names.ticks.labels, (std::vector<std::string>{"a", "b"}));
    EXPECT_NEAR(names.scale(0.0), 25.0, 1e-12);
    EXPECT_NEAR(names.scale(1.0), 75.0, 1e-12);
}

TEST(Labels, NeverOverlapAndKeepZero) {
    for (const double height : {12.0, 30.0, 55.0, 130.0, 400.0})
        for (const double highest : {0.3, 7.0, 1200.0}) {
            DataRange data(Axis{});
            data.add(-0.37 * highest), data.add(highest);
            PlannedAxis axis = plan_axis({}, data, 0.0, height, 0.0, 5.0);
            thin_labels(axis, 13.0);
            double last = std::numeric_limits<double>::infinity();
            int labels = 0;
            for (std::size_t i = 0; i < axis.ticks.values.size(); ++i) {
                if (axis.ticks.labels[i].empty()) continue;
                const double at = axis.scale(axis.ticks.values[i]);
                if (height >= 30.0) {
                    EXPECT_GE(last - at, 13.0) << height << " " << highest;
                }
                last = at;
                ++labels;
            }
            EXPECT_GE(labels, 2) << height << " " << highest;
        }
}

TEST(Layout, AlignsPanelsAndKeepsAllTextInsideTheFrame) {
    Chart chart{.title = "a title", .x = {"time", "s"}, .panels = {{}, {}, {}}};
    for (std::size_t p = 0; p < 3; ++p) {
        const double size = std::pow(10.0, static_cast<double>(p) * 2.0);
        chart.panels[p].y = {"z", "mm"};
        chart.panels[p].series = {{"a", {0.0, 1.0, 2.0}, {-size, 3.0 * size, size}}, {"b", {0.0, 2.0}, {0.0, size}}};
    }
    const Layout layout = lay_out(chart, {}, print_palette(), estimated_text_width, {40.0, 7.0});
    for (const PlacedPanel& panel : layout.panels) {
        EXPECT_EQ(panel.area.left, layout.panels[0].area.left);
        EXPECT_EQ(panel.area.width, layout.panels[0].area.width);
    }
    EXPECT_GT(layout.panels[1].area.top, layout.panels[0].area.bottom());
    const Rectangle& frame = layout.frame;
    EXPECT_EQ(frame.left, 40.0);
    for (const Text& text : marks_of<Text>(draw(chart, layout, print_palette()))) {
        const double width = estimated_text_width(text.text, text.size);
        const double left = text.at.x - width * (text.anchor == Anchor::start ? 0.0
                                                 : text.anchor == Anchor::end ? 1.0
                                                                              : 0.5);
        EXPECT_GE(left, frame.left) << text.text;
        EXPECT_LE(left + width, frame.right()) << text.text;
        EXPECT_GE(text.at.y - 0.5 * text.size, frame.top) << text.text;
        EXPECT_LE(text.at.y + 0.5 * text.size, frame.bottom()) << text.text;
    }
}

TEST(Layout, ReportAndWindowStyleShareTheTicks) {
    Chart chart{.x = {"time", "s"}, .panels = {{.y = {"z", "mm"}, .series = {{"a", {0.0, 1.7}, {-3.0, 8.0}}}}}};
    chart.x.lowest = 0.0, chart.x.highest = 1.7, chart.panels[0].y.lowest = -3.0, chart.panels[0].y.highest = 8.0;
    LayoutStyle window = compact_style(11.0, 1.0);
    const LayoutStyle page;
    window.x_tick = page.x_tick, window.y_tick = page.y_tick;
    const Layout a = lay_out(chart, page, print_palette(), estimated_text_width);
    const Layout b = lay_out(chart, window, print_palette(), estimated_text_width);
    EXPECT_EQ(a.x.ticks.values, b.x.ticks.values);
    EXPECT_EQ(a.panels[0].y.ticks.values, b.panels[0].y.ticks.values);
    EXPECT_EQ(a.panels[0].y.ticks.labels, b.panels[0].y.ticks.labels);
    EXPECT_EQ(axis_title(chart.panels[0].y, a.panels[0].y.ticks), "z [mm]");
    // The window has the unit at the ticks, the page in the title.
    EXPECT_EQ(b.x.ticks.labels.front(), "0.0 s");
    EXPECT_EQ(a.x.ticks.labels.front(), "0.0");
}

TEST(Layout, LegendOfTheWindowStaysBesideTheTitle) {
    Chart chart{.x = {"time", "s"}, .panels = {{.y = {"position", "mm"}}}, .width_px = 300.0};
    for (int s = 0; s < 12; ++s)
        chart.panels[0].series.push_back({"series " + std::to_string(s), {0.0, 1.0}, {0.0, 1.0}});
    const LayoutStyle style = compact_style(11.0, 1.0);
    const Layout layout = lay_out(chart, style, print_palette(), estimated_text_width);
    ASSERT_FALSE(layout.legend.empty());
    ASSERT_LT(layout.legend.size(), 12u);
    EXPECT_GE(layout.legend.front().box.left,
              style.right_margin + estimated_text_width("position [mm]", style.axis_title));
    for (std::size_t i = 1; i < layout.legend.size(); ++i)
        EXPECT_GT(layout.legend[i].box.left, layout.legend[i - 1].box.right());
    EXPECT_LE(layout.legend.back().box.right(), layout.panels[0].area.right() + 1e-9);
}

/// Labels at the ends are moved inwards, towards their neighbours.
TEST(Layout, TimesBelowANarrowPlotOfTheWindowDoNotOverlap) {
    const LayoutStyle style = compact_style(11.0, 1.0);
    for (double width = 140.0; width < 400.0; width += 7.0)
        for (const double end_s : {0.8, 1.0, 12.0}) {
            Chart chart{.x = {"time", "s"}, .panels = {{.y = {"z", "mm"}}}, .width_px = width};
            chart.panels[0].series = {{"a", {0.0, end_s}, {0.0, 1.0}}};
            chart.x.lowest = 0.0, chart.x.highest = end_s;
            const Layout layout = lay_out(chart, style, print_palette(), estimated_text_width);
            double free_from = -1.0;
            int labels = 0;
            for (const Text& text : marks_of<Text>(draw(chart, layout, print_palette()))) {
                if (!text.text.ends_with(" s")) continue;
                const double half = 0.5 * estimated_text_width(text.text, text.size);
                EXPECT_GT(text.at.x - half, free_from) << text.text << " below a plot of " << width;
                free_from = text.at.x + half;
                ++labels;
            }
            EXPECT_GE(labels, 2) << width;
        }
}

TEST(Drawing, CutsCurvesAtTheEndsOfTheAxis) {
    Chart chart{.x = {.lowest = 1.0, .highest = 3.0}, .panels = {{.y = {.lowest = 0.0, .highest = 8.0}}}};
    // A segment may cross the whole range, and a curve may go back.
    chart.panels[0].series = {{"", {0.0, 4.0, 2.0, nan, 2.5, 9.0}, {0.0, 8.0, 4.0, 0.0, 5.0, 5.0}}};
    const Layout layout = lay_out(chart, {}, print_palette(), estimated_text_width);
    const Rectangle& area = layout.panels[0].area;
    const Drawing drawing = draw(chart, layout, print_palette());
    std::vector<Polyline> curves;
    for (const Stroke& stroke : marks_of<Stroke>(drawing))
        if (stroke.colour == print_palette().series[0]) curves.push_back(stroke.points);
    ASSERT_EQ(curves.size(), 1u);
    const Polyline& curve = curves[0];
    std::vector<double> seen;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (curve.has_point(i)) {
            seen.push_back(layout.x.scale.value(curve.x[i]));
            EXPECT_GE(curve.x[i], area.left - 1e-9);
            EXPECT_LE(curve.x[i], area.right() + 1e-9);
        }
    ASSERT_EQ(seen.size(), 6u);
    const std::vector<double> expected = {1.0, 3.0, 3.0, 2.0, 2.5, 3.0};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(seen[i], expected[i], 1e-9) << i;
    EXPECT_NEAR(layout.panels[0].y.scale.value(curve.y[0]), 2.0, 1e-9) << "interpolated";
}

TEST(Drawing, BandsFollowTheCurveAndHiddenSeriesKeepTheirEntry) {
    Chart chart{.panels = {{.series = {{"a", {0.0, 1.0}, {2.0, 4.0}}, {"b", {0.0, 1.0}, {90.0, 90.0}}}}}};
    chart.panels[0].series[0].half_width = {0.5, 1.0};
    chart.panels[0].series[1].hidden = true;
    const Layout layout = lay_out(chart, {}, print_palette(), estimated_text_width);
    EXPECT_LT(layout.panels[0].y.scale.highest, 10.0) << "hidden series do not determine the range";
    const std::vector<Band> bands = marks_of<Band>(draw(chart, layout, print_palette()));
    ASSERT_EQ(bands.size(), 1u);
    const Scale& y = layout.panels[0].y.scale;
    EXPECT_NEAR(y.value(bands[0].upper[1]), 5.0, 1e-9);
    EXPECT_NEAR(y.value(bands[0].lower[0]), 1.5, 1e-9);
    ASSERT_EQ(layout.legend.size(), 2u);
    EXPECT_TRUE(layout.legend[1].entry.hidden);
    EXPECT_EQ(test::markup_fault(svg(drawing_of(chart, compact_style(12.0, 1.0)))), "");
}

}  // namespace
}  // namespace myo::chart
