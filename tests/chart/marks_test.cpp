#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "chart/drawing.hpp"
#include "support/not_finite.hpp"

namespace myo::chart::marks_test {
namespace {

using test::infinity;
using test::nan;

/// One panel over [0, 10] in x and y, of 240 px height.
Chart square(std::vector<Series> series = {}) {
    return {.x = {.lowest = 0.0, .highest = 10.0},
            .panels = {{.y = {.lowest = 0.0, .highest = 10.0}, .series = std::move(series)}}};
}

/// A chart with its layout and its marks.
struct Drawn {
    Layout layout;
    Drawing drawing;
    explicit Drawn(const Chart& chart, const LayoutStyle& style = {}, const Palette& palette = print_palette())
        : layout(lay_out(chart, style, palette, estimated_text_width)), drawing(draw(chart, layout, palette)) {}

    const Rectangle& area() const { return layout.panels[0].area; }
    const Scale& x() const { return layout.x.scale; }
    const Scale& y() const { return layout.panels[0].y.scale; }

    /// Marks of one kind that meet a condition.
    template <class Kind, class Condition>
    std::vector<Kind> marks(const Condition& condition) const {
        std::vector<Kind> found;
        for (const Mark& mark : drawing.marks)
            if (const Kind* one = std::get_if<Kind>(&mark))
                if (condition(*one)) found.push_back(*one);
        return found;
    }
    std::vector<Text> texts(const std::string& text) const {
        return marks<Text>([&](const Text& one) { return one.text == text; });
    }
    /// Boxes in the colour of a slot.
    std::vector<Box> boxes(int slot) const {
        return marks<Box>([&](const Box& one) { return one.colour == print_palette().slot(slot); });
    }
    /// Number of dashed lines in the colour of references.
    std::size_t references() const {
        return marks<Stroke>([](const Stroke& s) { return s.dash > 0.0 && s.colour == print_palette().quiet; }).size();
    }
};

TEST(ReferenceLines, AreDrawnUpToHalfAPixelBeyondTheArea) {
    const Drawn plain(square());
    for (const double beyond : {0.4, 0.6}) {
        Chart chart = square();
        const Rectangle& area = plain.area();
        chart.panels[0].horizontal = {{plain.y().value(area.top - beyond), ""},
                                      {plain.y().value(area.bottom() + beyond), ""}};
        EXPECT_EQ(Drawn(chart).references(), beyond < 0.5 ? 2u : 0u);
        chart.panels[0].horizontal.clear();
        chart.panels[0].vertical = {{plain.x().value(area.left - beyond), ""},
                                    {plain.x().value(area.right() + beyond), ""}};
        EXPECT_EQ(Drawn(chart).references(), beyond < 0.5 ? 2u : 0u);
    }
}

TEST(ReferenceLines, HaveLabelsAboveOrBelowWhereThereIsRoom) {
    const Drawn plain(square());
    // A label is 11 px high and its middle 8.25 px from the line: 13.75 px are needed above.
    for (const double room : {13.7, 13.8}) {
        Chart chart = square();
        chart.panels[0].horizontal = {{plain.y().value(plain.area().top + room), "limit"}};
        const Drawn drawn(chart);
        const std::vector<Text> labels = drawn.texts("limit");
        ASSERT_EQ(labels.size(), 1u);
        EXPECT_NEAR(labels[0].at.y - (plain.area().top + room), room < 13.75 ? 8.25 : -8.25, 1e-9);
        EXPECT_EQ(labels[0].anchor, Anchor::end);
        EXPECT_LT(labels[0].at.x, drawn.area().right());
    }
}

TEST(ReferenceLines, HaveLabelsLeftOrRightWhereThereIsRoom) {
    const Drawn plain(square());
    const std::string label = "ten digits";
    const double needed = 5.0 + estimated_text_width(label, plain.layout.style.text);
    for (const double spare : {-0.1, 0.1}) {
        Chart chart = square();
        const double at = plain.area().right() - needed - spare;
        chart.panels[0].vertical = {{plain.x().value(at), label}};
        const std::vector<Text> labels = Drawn(chart).texts(label);
        ASSERT_EQ(labels.size(), 1u);
        EXPECT_EQ(labels[0].anchor, spare < 0.0 ? Anchor::end : Anchor::start);
        EXPECT_NEAR(labels[0].at.x, at + (spare < 0.0 ? -5.0 : 5.0), 1e-9);
    }
}

TEST(ReferenceLines, SpreadTheirLabelsOverThreeRows) {
    Chart chart = square();
    chart.panels[0].vertical = {{1.0, "a"}, {2.0, "b"}, {2.5, ""}, {-50.0, "outside"}, {3.0, "c"}, {4.0, "d"}};
    const Drawn drawn(chart);
    EXPECT_EQ(drawn.references(), 5u);
    EXPECT_TRUE(drawn.texts("outside").empty());
    std::vector<double> rows;
    for (const char* name : {"a", "b", "c", "d"}) {
        ASSERT_EQ(drawn.texts(name).size(), 1u) << name;
        rows.push_back(drawn.texts(name)[0].at.y);
    }
    EXPECT_GT(rows[1] - rows[0], drawn.layout.style.text);
    EXPECT_DOUBLE_EQ(rows[2] - rows[1], rows[1] - rows[0]);
    EXPECT_DOUBLE_EQ(rows[3], rows[0]);
}

TEST(SpanMarks, AreCutAtTheAreaAndLeftOutBeyondIt) {
    Chart chart = square();
    chart.panels[0].spans = {{-infinity, infinity, "all"}, {2.0, 4.0, "part"},   {8.0, 30.0, "end"},
                             {-9.0, -1.0, "before"},       {4.0, 2.0, "turned"}, {nan, 3.0, "none"}};
    const Drawn drawn(chart);
    const std::vector<Box> shades = drawn.marks<Box>(
        [](const Box& box) { return box.colour == print_palette().shade; });
    ASSERT_EQ(shades.size(), 3u);
    const Rectangle& area = drawn.area();
    const double tenth = 0.1 * area.width;
    const std::vector<double> from = {0.0, 2.0, 8.0}, wide = {10.0, 2.0, 2.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(shades[i].area.left, area.left + from[i] * tenth, 1e-9);
        EXPECT_NEAR(shades[i].area.width, wide[i] * tenth, 1e-9);
        EXPECT_EQ(shades[i].area.top, area.top);
        EXPECT_EQ(shades[i].area.height, area.height);
    }
    for (const char* seen : {"all", "part", "end"}) EXPECT_EQ(drawn.texts(seen).size(), 1u) << seen;
    for (const char* unseen : {"before", "turned", "none"}) EXPECT_TRUE(drawn.texts(unseen).empty()) << unseen;
}

TEST(BarMarks, ReachFromZeroToTheirValueAndEndAtTheArea) {
    Series bars{.x = {1, 3, 5, 7, 20}, .y = {2, -1, 70, nan, 1}, .style = SeriesStyle::bars, .colour = 0};
    bars.ends = {{0, 2}, {2, 4}, {4, 6}, {6, 8}, {19, 21}};
    Chart chart = square({bars});
    chart.panels[0].y.lowest = -2.0;
    const Drawn drawn(chart);
    const Scale& y = drawn.y();
    const std::vector<Box> boxes = drawn.boxes(0);
    ASSERT_EQ(boxes.size(), 3u) << "neither the gap nor the bar outside";
    EXPECT_NEAR(boxes[0].area.top, y(2.0), 1e-9);
    EXPECT_NEAR(boxes[0].area.bottom(), y(0.0), 1e-9);
    EXPECT_NEAR(boxes[1].area.top, y(0.0), 1e-9);
    EXPECT_NEAR(boxes[1].area.bottom(), y(-1.0), 1e-9);
    EXPECT_NEAR(boxes[2].area.top, drawn.area().top, 1e-9);
    // Half a pixel is left free on each side.
    EXPECT_NEAR(boxes[0].area.left, drawn.x()(0.0) + 0.5, 1e-9);
    EXPECT_NEAR(boxes[1].area.left - boxes[0].area.right(), 1.0, 1e-9);
    EXPECT_GT(boxes[0].radius, 0.0);
}

TEST(BarMarks, WithoutZeroOnTheAxisStartAtItsEnd) {
    Series bars{.x = {5}, .y = {10}, .style = SeriesStyle::bars, .colour = 0, .ends = {{4.99, 5.0}}};
    Chart chart = square({bars});
    chart.panels[0].y = {.lowest = 1.0, .highest = 100.0, .logarithmic = true};
    const Drawn decades(chart);
    ASSERT_EQ(decades.boxes(0).size(), 1u);
    const Box bar = decades.boxes(0)[0];
    EXPECT_NEAR(bar.area.bottom(), decades.area().bottom(), 1e-9);
    EXPECT_NEAR(bar.area.height, 120.0, 1e-9) << "one of two decades";
    EXPECT_EQ(bar.area.width, 0.5) << "a bar is never invisible";
    EXPECT_EQ(bar.radius, 0.0);
    chart.panels[0].y = {.lowest = -30.0, .highest = -5.0};
    chart.panels[0].series[0].y = {-10.0};
    const Drawn below(chart);
    ASSERT_EQ(below.boxes(0).size(), 1u);
    EXPECT_NEAR(below.boxes(0)[0].area.top, below.area().top, 1e-9) << "from the end that is next to zero";
    EXPECT_NEAR(below.boxes(0)[0].area.height, 48.0, 1e-9) << "5 of 25";
}

TEST(DotMarks, OutsideTheAreaAreLeftOut) {
    Series dots{.x = {1, 2, 3, -1, 11, 4}, .y = {0, 10, 5, 5, 5, nan}, .style = SeriesStyle::dots, .colour = 0};
    dots.x.push_back(5), dots.y.push_back(11);  // 24 px above
    const std::vector<Dots> marks = Drawn(square({dots})).marks<Dots>([](const Dots&) { return true; });
    ASSERT_EQ(marks.size(), 1u);
    EXPECT_EQ(marks[0].centres.x.size(), 3u);
}

TEST(DotMarks, LieAboveLinesWhateverTheirOrder) {
    const Series dots{.x = {1, 2}, .y = {1, 2}, .style = SeriesStyle::dots, .colour = 0};
    const Series line{.x = {1, 2}, .y = {1, 2}, .colour = 1};
    const Drawn drawn(square({dots, line}));
    std::size_t at_line = 0, at_dots = 0;
    for (std::size_t i = 0; i < drawn.drawing.marks.size(); ++i) {
        const Stroke* stroke = std::get_if<Stroke>(&drawn.drawing.marks[i]);
        if (stroke != nullptr && stroke->colour == print_palette().slot(1)) at_line = i;
        if (std::holds_alternative<Dots>(drawn.drawing.marks[i])) at_dots = i;
    }
    EXPECT_GT(at_line, 0u);
    EXPECT_GT(at_dots, at_line);
}

}  // namespace
}  // namespace myo::chart::marks_test
