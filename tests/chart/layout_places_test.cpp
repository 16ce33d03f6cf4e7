#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/markup.hpp"
#include "chart/layout.hpp"

namespace myo::chart::layout_places_test {
namespace {

/// Every letter is six pixels wide, whatever its size.
double six_px(std::string_view text, double) { return 6.0 * character_count(text); }

Layout placed(const Chart& chart, const LayoutStyle& style = {}, const Point& origin = {}) {
    return lay_out(chart, style, print_palette(), six_px, origin);
}

Chart curves(std::size_t count, const std::string& name = "curve ") {
    Chart chart{.x = {"time", "s"}, .panels = {{.y = {"z", "mm"}}}};
    for (std::size_t i = 0; i < count; ++i)
        chart.panels[0].series.push_back({.name = name + std::to_string(i), .x = {0, 1}, .y = {0, 1}});
    return chart;
}

TEST(ChartHeight, IsThatOfThePanelAndWhatIsAdded) {
    for (const LayoutStyle& style : {LayoutStyle{}, compact_style(11.0, 1.0), compact_style(13.0, 2.0)})
        for (const bool heading : {false, true})
            for (const bool labels : {false, true}) {
                Chart chart = curves(1);
                chart.legend = false;
                chart.x_labels = labels;
                if (!heading) {
                    chart.panels[0].y = {};
                    // Pages leave the heading out for names of rows only.
                    if (!style.compact) chart.panels[0].y.categories = {"a", "b"};
                }
                EXPECT_NEAR(placed(chart, style).frame.height,
                            chart.panels[0].height_px + added_height(style, heading, labels), 1e-9)
                    << style.compact << heading << labels;
            }
}

TEST(ChartHeight, HasRoomForATitleAndALegend) {
    const double plain = placed(curves(1)).frame.height;
    Chart titled = curves(1);
    titled.title = "title";
    EXPECT_NEAR(placed(titled).frame.height - plain, LayoutStyle{}.title_height, 1e-9);
    // One curve has no entry on pages; the second one brings a line.
    EXPECT_TRUE(placed(curves(1)).legend.empty());
    EXPECT_EQ(placed(curves(2)).legend.size(), 2u);
    EXPECT_GT(placed(curves(2)).frame.height, plain + LayoutStyle{}.legend);
    Chart silent = curves(2);
    silent.legend = false;
    EXPECT_TRUE(placed(silent).legend.empty());
    EXPECT_EQ(placed(silent).frame.height, plain);
    // The window names a single curve too, in the line of the title.
    EXPECT_EQ(placed(curves(1), compact_style(11.0, 1.0)).legend.size(), 1u);
}

TEST(ChartWidth, IsTheGivenOneAndItsPanelsAreNeverTooNarrow) {
    const Layout layout = placed(curves(1));
    EXPECT_NEAR(layout.frame.width, 760.0, 1e-9);
    EXPECT_NEAR(layout.panels[0].area.right() + LayoutStyle{}.right_margin, layout.frame.right(), 1e-9);
    Chart narrow = curves(1);
    narrow.width_px = 20.0;
    EXPECT_EQ(placed(narrow).panels[0].area.width, 60.0);
    EXPECT_GT(placed(narrow).frame.width, 60.0);
    EXPECT_EQ(placed(narrow, compact_style(11.0, 1.0)).panels[0].area.width, 0.0) << "the window has what it has";
}

TEST(ChartPlace, MovesEverythingByTheOrigin) {
    Chart chart = curves(7);
    chart.title = "title";
    chart.panels.push_back(chart.panels[0]);
    for (const LayoutStyle& style : {LayoutStyle{}, compact_style(11.0, 1.0)}) {
        const Layout here = placed(chart, style), there = placed(chart, style, {100.0, 50.0});
        EXPECT_NEAR(there.title.x - here.title.x, 100.0, 1e-9);
        EXPECT_NEAR(there.title.y - here.title.y, 50.0, 1e-9);
        EXPECT_NEAR(there.frame.right() - here.frame.right(), 100.0, 1e-9);
        EXPECT_NEAR(there.frame.bottom() - here.frame.bottom(), 50.0, 1e-9);
        EXPECT_NEAR(there.x.scale(0.5) - here.x.scale(0.5), 100.0, 1e-9);
        for (std::size_t p = 0; p < 2; ++p) {
            EXPECT_NEAR(there.panels[p].area.top - here.panels[p].area.top, 50.0, 1e-9);
            EXPECT_NEAR(there.panels[p].y.scale(0.5) - here.panels[p].y.scale(0.5), 50.0, 1e-9);
        }
        ASSERT_EQ(there.legend.size(), here.legend.size());
        for (std::size_t i = 0; i < here.legend.size(); ++i) {
            EXPECT_NEAR(there.legend[i].box.left - here.legend[i].box.left, 100.0, 1e-9);
            EXPECT_NEAR(there.legend[i].box.top - here.legend[i].box.top, 50.0, 1e-9);
        }
    }
}

TEST(PanelPlaces, HaveTheEndsOfTheirScaleAtTheirEdges) {
    Chart chart = curves(1);
    chart.panels.push_back({.y = {"w"}, .series = {{.x = {0, 1}, .y = {-5, 5}}}, .height_px = 90.0});
    const Layout layout = placed(chart);
    for (const PlacedPanel& panel : layout.panels) {
        EXPECT_NEAR(panel.y.scale(panel.y.scale.lowest), panel.area.bottom(), 1e-9) << "pixels grow downwards";
        EXPECT_NEAR(panel.y.scale(panel.y.scale.highest), panel.area.top, 1e-9);
    }
    EXPECT_EQ(layout.panels[1].area.height, 90.0);
    EXPECT_NEAR(layout.panels[1].area.top - layout.panels[0].area.bottom(),
                LayoutStyle{}.panel_gap + LayoutStyle{}.panel_heading, 1e-9);
    EXPECT_NEAR(layout.x.scale(0.0), layout.panels[0].area.left, 1e-9) << "curves may touch the edges";
    EXPECT_NEAR(layout.x.scale(1.0), layout.panels[0].area.right(), 1e-9);
}

TEST(LegendPlaces, WrapWithoutLeavingTheChartOrAnEmptyLine) {
    const Layout layout = placed(curves(9, "a curve with a long name "));
    const Rectangle& area = layout.panels[0].area;
    ASSERT_EQ(layout.legend.size(), 9u);
    const double width = legend_entry_width(layout.legend[0].entry, layout.style, six_px);
    EXPECT_NEAR(width, layout.style.legend_sample + 0.5 * layout.style.legend + 6.0 * 26.0, 1e-9);
    // As many per line as fit with a gap between them.
    const double gap = layout.style.legend_gap;
    const auto per_line = static_cast<std::size_t>((area.width + gap) / (width + gap));
    ASSERT_GE(per_line, 2u);
    for (std::size_t i = 0; i < 9; ++i) {
        const Rectangle& box = layout.legend[i].box;
        EXPECT_NEAR(box.left, area.left + static_cast<double>(i % per_line) * (width + gap), 1e-9) << i;
        EXPECT_LE(box.right(), area.right() + 1e-9);
        EXPECT_LT(box.bottom(), area.top);
        if (i < per_line) continue;
        EXPECT_GE(box.top, layout.legend[i - per_line].box.bottom());
    }
    // A name wider than the chart has a line to itself.
    const Layout wide = placed(curves(2, std::string(300, 'w')));
    EXPECT_EQ(wide.legend[0].box.left, wide.legend[1].box.left);
    EXPECT_LT(wide.legend[0].box.top, wide.legend[1].box.top);
}

TEST(CategoryNames, AreTurnedWhereTheyAreWiderThanTheirPlaces) {
    const auto named = [](std::size_t letters) {
        BarChart bars{.categories = {"a", std::string(letters, 'n'), "c", "d"}};
        bars.groups = {{"g", {1, 2, 3, 4}}};
        return placed(chart_of(bars));
    };
    const double place = named(1).panels[0].area.width / 4.0 - 10.0;
    const auto most = static_cast<std::size_t>(place / 6.0);
    EXPECT_FALSE(named(most).turned);
    EXPECT_TRUE(named(most + 1).turned);
    EXPECT_GT(named(most + 1).frame.height, named(most).frame.height);
    // Long names are cut off instead of making the chart higher.
    EXPECT_EQ(named(1000).frame.height, named(400).frame.height);
}

TEST(RowNames, TakeAtMostHalfOfTheWidth) {
    const auto named = [](std::size_t letters) {
        return placed(chart_of(ErrorBarChart{.rows = {{std::string(letters, 'n'), 1.0, 0.0, 2.0}}}));
    };
    EXPECT_NEAR(named(40).panels[0].area.left, 6.0 * 40.0 + 16.0, 1e-9);
    EXPECT_NEAR(named(400).panels[0].area.left, 380.0, 1e-9);
    // Intervals do not touch the edges.
    const Layout layout = named(10);
    EXPECT_NEAR(layout.x.scale.lowest, -0.1, 1e-12);
    EXPECT_NEAR(layout.x.scale.highest, 2.1, 1e-12);
}

TEST(RangesOfCharts, FollowBandsReferencesAndRowReferences) {
    Chart chart = curves(1);
    chart.panels[0].series[0].half_width = {0.5, 2.0};
    LayoutStyle style;
    style.y_padding = 0.0;
    EXPECT_EQ(placed(chart, style).panels[0].y.scale.range(), (Range{-1.0, 3.0}));
    chart.panels[0].horizontal = {{7.0, "limit"}};
    chart.panels[0].vertical = {{50.0, "late"}};
    const Layout layout = placed(chart, style);
    EXPECT_EQ(layout.panels[0].y.scale.highest, 7.0);
    EXPECT_EQ(layout.x.scale.highest, 1.0) << "vertical lines do not extend the axis of curves";
    ErrorBarChart rows{.rows = {{"a", 1.0, 0.0, 2.0}}, .vertical = {{8.0, "zero"}}};
    EXPECT_EQ(placed(chart_of(rows), style).x.scale.range(), (Range{0.0, 8.0})) << "but those of rows";
}

TEST(WindowStyle, GrowsWithTheFontAndTheScaleOfTheScreen) {
    const LayoutStyle one = compact_style(11.0, 1.0), two = compact_style(22.0, 2.0);
    EXPECT_DOUBLE_EQ(two.line, 2.0 * one.line);
    EXPECT_DOUBLE_EQ(two.left_margin, 2.0 * one.left_margin);
    EXPECT_DOUBLE_EQ(two.panel_heading, 2.0 * one.panel_heading);
    EXPECT_DOUBLE_EQ(two.x_tick, 2.0 * one.x_tick);
    EXPECT_EQ(two.y_padding, one.y_padding);
    // Twice the size in twice the pixels is the picture itself, with the ticks it had.
    Chart small = curves(2), large = curves(2);
    large.width_px = 2.0 * small.width_px, large.panels[0].height_px = 2.0 * small.panels[0].height_px;
    const auto scaled = [](std::string_view text, double size) { return 0.5 * size * character_count(text); };
    const Layout a = lay_out(small, one, print_palette(), scaled), b = lay_out(large, two, print_palette(), scaled);
    EXPECT_NEAR(b.frame.height, 2.0 * a.frame.height, 1e-9);
    EXPECT_NEAR(b.panels[0].area.width, 2.0 * a.panels[0].area.width, 1e-9);
    EXPECT_EQ(a.x.ticks.labels, b.x.ticks.labels);
    EXPECT_EQ(a.panels[0].y.ticks.labels, b.panels[0].y.ticks.labels);
}

}  // namespace
}  // namespace myo::chart::layout_places_test
