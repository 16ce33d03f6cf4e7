#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "chart/drawing.hpp"
#include "chart/look.hpp"
#include "support/not_finite.hpp"

namespace myo::chart::series_marks_test {
namespace {

/// All marks of one kind.
template <class Kind>
std::vector<Kind> all(const Drawing& drawing) {
    std::vector<Kind> found;
    for (const Mark& mark : drawing.marks)
        if (const Kind* one = std::get_if<Kind>(&mark)) found.push_back(*one);
    return found;
}

Layout placed(const Chart& chart, const LayoutStyle& style = {}) {
    return lay_out(chart, style, print_palette(), estimated_text_width);
}

Chart one_series(const Series& series) {
    return {.x = {.lowest = 0.0, .highest = 10.0},
            .panels = {{.y = {.lowest = 0.0, .highest = 10.0}, .series = {series}}}};
}

/// Strokes of a chart in one colour.
std::vector<Stroke> strokes_of(const Chart& chart, const Colour& colour) {
    std::vector<Stroke> found;
    for (const Stroke& stroke : all<Stroke>(draw(chart, placed(chart), print_palette())))
        if (stroke.colour == colour) found.push_back(stroke);
    return found;
}

TEST(SeriesLooks, BeyondThePaletteAreDottedAndDashedOnesKeepTheirPattern) {
    const int count = static_cast<int>(print_palette().series.size());
    for (const int slot : {0, count - 1, count, 2 * count}) {
        const Series line{.x = {0, 1}, .y = {0, 1}, .colour = slot};
        const LegendEntry look = look_of(line, {}, print_palette());
        EXPECT_EQ(look.dotted, slot >= count) << slot;
        EXPECT_EQ(look.colour, print_palette().slot(slot));
        const std::vector<Stroke> drawn = strokes_of(one_series(line), look.colour);
        ASSERT_EQ(drawn.size(), 1u);
        EXPECT_EQ(drawn[0].dash > 0.0, slot >= count);
        Series dashed = line;
        dashed.style = SeriesStyle::dashed;
        const std::vector<Stroke> longer = strokes_of(one_series(dashed), look.colour);
        ASSERT_EQ(longer.size(), 1u);
        EXPECT_GT(longer[0].dash, drawn[0].dash);
    }
}

TEST(SeriesLooks, NamesHaveOneSlotEachAndFixedColoursTakeNone) {
    Chart chart{.panels = {{}, {}}};
    chart.panels[0].series = {{.name = "a"}, {.name = "fixed", .colour = 3}, {.name = "own"}, {.name = "b"}};
    chart.panels[0].series[2].own_colour = Colour{0x123456, 1.0};
    chart.panels[1].series = {{.name = "b"}, {.name = "ink", .colour = ink_colour}, {.name = "c"}};
    const std::map<std::string, int> slots = slots_of_names(chart);
    EXPECT_EQ(slots, (std::map<std::string, int>{{"a", 0}, {"b", 1}, {"c", 2}}));
    EXPECT_EQ(look_of(chart.panels[0].series[1], slots, print_palette()).colour, print_palette().slot(3));
    EXPECT_EQ(look_of(chart.panels[0].series[2], slots, print_palette()).colour, (Colour{0x123456, 1.0}));
    EXPECT_EQ(look_of(chart.panels[1].series[1], slots, print_palette()).colour, print_palette().text);
    EXPECT_EQ(look_of(chart.panels[1].series[2], slots, print_palette()).colour, print_palette().slot(2));
}

TEST(Intervals, EndAtTheAreaAndNeedBothEnds) {
    Series estimates{.x = {2, 5, 8, 4}, .y = {1, 2, 3, 4}, .style = SeriesStyle::dots, .colour = 0};
    estimates.ends = {{1, 3}, {-50, 7}, {test::nan, 9}, {3, test::infinity}};
    const Chart chart = one_series(estimates);
    const Layout layout = placed(chart);
    const std::vector<Stroke> strokes = strokes_of(chart, print_palette().slot(0));
    ASSERT_EQ(strokes.size(), 6u) << "a line and two caps for two of the four";
    const Scale &x = layout.x.scale, &y = layout.panels[0].y.scale;
    for (std::size_t i = 0; i < 2; ++i) {
        const Polyline& line = strokes[3 * i].points;
        EXPECT_NEAR(line.x[0], i == 0 ? x(1.0) : layout.panels[0].area.left, 1e-9);
        EXPECT_NEAR(line.x[1], x(i == 0 ? 3.0 : 7.0), 1e-9);
        EXPECT_NEAR(line.y[0], y(i == 0 ? 1.0 : 2.0), 1e-9);
        EXPECT_EQ(line.y[0], line.y[1]);
        for (std::size_t end = 0; end < 2; ++end) {
            const Polyline& cap = strokes[3 * i + 1 + end].points;
            EXPECT_EQ(cap.x, (std::vector<double>{line.x[end], line.x[end]}));
            EXPECT_NEAR(0.5 * (cap.y[0] + cap.y[1]), line.y[0], 1e-9);
        }
    }
    // Dots of estimates are larger than those of samples.
    const std::vector<Dots> dots = all<Dots>(draw(chart, layout, print_palette()));
    ASSERT_EQ(dots.size(), 1u);
    EXPECT_DOUBLE_EQ(dots[0].diameter, 2.0 * layout.style.dot);
}

TEST(Diamonds, AreCentredOnTheirSamplesAndHaveTheColourOfThePaper) {
    const Chart chart = one_series({.x = {2, 50, 4}, .y = {3, 3, test::nan}, .style = SeriesStyle::diamonds});
    const Layout layout = placed(chart);
    const std::vector<Polygon> diamonds = all<Polygon>(draw(chart, layout, print_palette()));
    // A curve that leaves the axis is cut at the edge, where it has no sample.
    ASSERT_EQ(diamonds.size(), 1u);
    const Polyline& corners = diamonds[0].corners;
    ASSERT_EQ(corners.x.size(), 4u);
    const auto [left, right] = std::minmax_element(corners.x.begin(), corners.x.end());
    const auto [top, bottom] = std::minmax_element(corners.y.begin(), corners.y.end());
    EXPECT_NEAR(0.5 * (*left + *right), layout.x.scale(2.0), 1e-9);
    EXPECT_NEAR(0.5 * (*top + *bottom), layout.panels[0].y.scale(3.0), 1e-9);
    EXPECT_EQ(diamonds[0].fill, print_palette().paper);
    EXPECT_EQ(diamonds[0].edge, print_palette().slot(0));
}

TEST(LonelySamples, AreDotsSmallerThanThoseOfASeriesOfDots) {
    const double gap = test::nan;
    const Chart chart = one_series({.x = {0, 1, 2, 3, 4, 5}, .y = {1, gap, 3, gap, 5, 6}});
    const Layout layout = placed(chart);
    const std::vector<Dots> dots = all<Dots>(draw(chart, layout, print_palette()));
    ASSERT_EQ(dots.size(), 1u);
    ASSERT_EQ(dots[0].centres.x.size(), 2u) << "the first sample and the third";
    EXPECT_NEAR(dots[0].centres.y[0], layout.panels[0].y.scale(1.0), 1e-9);
    EXPECT_NEAR(dots[0].centres.y[1], layout.panels[0].y.scale(3.0), 1e-9);
    EXPECT_LT(dots[0].diameter, layout.style.dot);
    const Chart whole = one_series({.x = {0, 1, 2}, .y = {1, 2, 3}});
    EXPECT_TRUE(all<Dots>(draw(whole, placed(whole), print_palette())).empty());
}

TEST(Grids, EmphasiseZeroOnLinearAxesOfNumbers) {
    const auto emphasised = [](const Axis& axis) {
        const Chart chart{.panels = {{.y = axis}}};
        const Layout layout = placed(chart);
        std::vector<double> heights;
        for (const Stroke& stroke : all<Stroke>(draw(chart, layout, print_palette())))
            if (stroke.colour == print_palette().axis && stroke.points.y[0] == stroke.points.y[1])
                heights.push_back(layout.panels[0].y.scale.value(stroke.points.y[0]));
        return heights;
    };
    // The last one is the line of the horizontal axis, at the lower end.
    const std::vector<double> linear = emphasised({.lowest = -4.0, .highest = 6.0});
    ASSERT_EQ(linear.size(), 2u);
    EXPECT_NEAR(linear[0], 0.0, 1e-9);
    EXPECT_NEAR(linear[1], -4.0, 1e-9);
    EXPECT_EQ(emphasised({.categories = {"first", "second"}}).size(), 1u);
    EXPECT_EQ(emphasised({.lowest = 1.0, .highest = 100.0, .logarithmic = true}).size(), 1u);
}

TEST(Grids, OfTheWindowAreVerticalTooAndLabelsStayInside) {
    Chart chart = one_series({.x = {0, 10}, .y = {0, 10}});
    const LayoutStyle style = compact_style(11.0, 1.0);
    const Layout layout = placed(chart, style);
    const Rectangle& area = layout.panels[0].area;
    const Drawing drawing = draw(chart, layout, print_palette());
    std::size_t vertical = 0;
    for (const Stroke& stroke : all<Stroke>(drawing))
        if (stroke.points.x[0] == stroke.points.x[1] && stroke.colour == print_palette().grid) ++vertical;
    EXPECT_EQ(vertical, layout.x.ticks.values.size());
    for (const Text& text : all<Text>(drawing)) {
        if (text.anchor != Anchor::end || text.text.empty()) continue;
        EXPECT_GE(text.at.y, area.top + 2.5 - 1e-9) << text.text;
        EXPECT_LE(text.at.y, area.bottom() - 2.5 + 1e-9) << text.text;
    }
}

TEST(Plots, HaveAGroundOfTheirOwnOnlyInAColourOfTheirOwn) {
    const Chart chart = one_series({.x = {0, 1}, .y = {0, 1}});
    const Layout layout = placed(chart);
    EXPECT_EQ(all<Box>(draw(chart, layout, print_palette())).size(), 1u) << "the paper";
    Palette dark = print_palette();
    dark.plot = Colour{0x101010, 1.0};
    const std::vector<Box> boxes = all<Box>(draw(chart, layout, dark));
    ASSERT_EQ(boxes.size(), 2u);
    EXPECT_EQ(boxes[1].colour, dark.plot);
    EXPECT_EQ(boxes[1].area.left, layout.panels[0].area.left);
    EXPECT_EQ(boxes[1].area.height, layout.panels[0].area.height);
}

}  // namespace
}  // namespace myo::chart::series_marks_test
