#include <gtest/gtest.h>

#include <string>

#include "chart/svg.hpp"
#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo::chart::svg_marks_test {
namespace {

using test::nan;

const Colour red{0xd00010, 1.0};

/// What svg() writes for one mark, without the document around it.
std::string written(const Mark& mark) {
    const std::string empty = svg(Drawing{{0.0, 0.0, 10.0, 10.0}, "t", {}});
    const std::string full = svg(Drawing{{0.0, 0.0, 10.0, 10.0}, "t", {mark}});
    const std::string end = "</svg>\n";
    EXPECT_TRUE(full.ends_with(end));
    const std::size_t before = empty.size() - end.size();
    return full.substr(before, full.size() - before - end.size());
}

TEST(SvgMarks, BoxesHaveNoNegativeSize) {
    EXPECT_EQ(written(Box{{1.0, 2.0, 3.5, 4.25}, red}),
              "<rect x=\"1\" y=\"2\" width=\"3.5\" height=\"4.25\" fill=\"#d00010\"/>\n");
    EXPECT_EQ(written(Box{{1.0, 2.0, -3.0, -4.0}, faded(red, 0.5), 1.5}),
              "<rect x=\"1\" y=\"2\" width=\"0\" height=\"0\" fill=\"#d00010\" fill-opacity=\"0.5\" rx=\"1.5\"/>\n");
}

TEST(SvgMarks, LinesAndCurvesHaveTheirDashes) {
    EXPECT_EQ(written(Stroke{{{0.0, 5.0}, {1.0, 2.0}}, red, 1.6}),
              "<line x1=\"0\" y1=\"1\" x2=\"5\" y2=\"2\" stroke=\"#d00010\" stroke-width=\"1.6\"/>\n");
    EXPECT_EQ(written(Stroke{{{0.0, 5.0, 6.0}, {1.0, 2.0, 0.0}}, red, 1.0, 6.0, 4.0}),
              "<path d=\"M0 1L5 2L6 0\" fill=\"none\" stroke=\"#d00010\" stroke-width=\"1\" "
              "stroke-dasharray=\"6 4\" stroke-linejoin=\"round\"/>\n");
}

TEST(SvgMarks, CurvesBreakAtGapsInEitherCoordinate) {
    const std::string path = written(
        Stroke{{{0.0, 1.0, nan, 3.0, 4.0, 5.0, 6.0}, {0.0, 1.0, 2.0, 3.0, 4.0, nan, 6.0}}, red});
    EXPECT_NE(path.find("d=\"M0 0L1 1M3 3L4 4\""), std::string::npos) << path;
    // Two points of which one is a gap are no line, and a single point has no length.
    EXPECT_EQ(written(Stroke{{{0.0, 1.0}, {0.0, nan}}, red}), "");
    EXPECT_EQ(written(Stroke{{{1.0}, {1.0}}, red}), "");
    EXPECT_EQ(written(Stroke{{{}, {}}, red}), "");
}

TEST(SvgMarks, BandsAreClosedOutlinesBetweenGaps) {
    const Band band{{0.0, 1.0, 2.0, 3.0, 4.0}, {5.0, 6.0, 7.0, 8.0, 9.0}, {1.0, 2.0, nan, 3.0, 4.0}, red};
    EXPECT_EQ(written(band), "<path d=\"M0 5L1 6L1 2L0 1ZM3 8L4 9L4 4L3 3Z\" fill=\"#d00010\"/>\n");
    EXPECT_EQ(written(Band{{0.0}, {nan}, {1.0}, red}), "");
    EXPECT_EQ(written(Band{{}, {}, {}, red}), "");
}

TEST(SvgMarks, DotsAreStrokesOfNoLengthWithRoundEnds) {
    EXPECT_EQ(written(Dots{{{1.0, nan, 3.0}, {2.0, 2.0, 4.0}}, red, 4.2}),
              "<path d=\"M1 2h0M3 4h0\" fill=\"none\" stroke=\"#d00010\" stroke-width=\"4.2\" "
              "stroke-linecap=\"round\"/>\n");
    EXPECT_EQ(written(Dots{{{nan}, {0.0}}, red}), "");
}

TEST(SvgMarks, PolygonsAreClosedAndHaveAnEdge) {
    EXPECT_EQ(written(Polygon{{{0.0, 1.0, 1.0}, {0.0, 0.0, 1.0}}, red, {0x0000ff, 0.25}, 1.8}),
              "<path d=\"M0 0L1 0L1 1Z\" fill=\"#d00010\" stroke=\"#0000ff\" stroke-opacity=\"0.25\" "
              "stroke-width=\"1.8\"/>\n");
}

TEST(SvgMarks, TextStandsOnItsBaseLine) {
    Text text{{10.0, 20.0}, "a<b", red, 10.0};
    EXPECT_EQ(written(text), "<text x=\"10\" y=\"23.6\" font-size=\"10\" fill=\"#d00010\">a&lt;b</text>\n");
    text.anchor = Anchor::middle;
    EXPECT_NE(written(text).find(" text-anchor=\"middle\""), std::string::npos);
    text.anchor = Anchor::end;
    text.bold = true;
    text.turned = -35.0;
    text.halo = Colour{0xffffff, 1.0};
    const std::string all = written(text);
    EXPECT_NE(all.find(" text-anchor=\"end\""), std::string::npos);
    EXPECT_NE(all.find(" font-weight=\"600\""), std::string::npos);
    // Turned about its place, not about the base line.
    EXPECT_NE(all.find(" transform=\"rotate(-35 10 20)\""), std::string::npos);
    EXPECT_NE(all.find(" stroke=\"#ffffff\" stroke-width=\"3\""), std::string::npos);
    EXPECT_NE(all.find(" paint-order=\"stroke\""), std::string::npos);
    EXPECT_EQ(written(Text{{1.0, 1.0}, "", red}), "");
}

TEST(SvgMarks, CutsAreNestedDocumentsInTheSameCoordinates) {
    const Drawing drawing{{0.0, 0.0, 100.0, 50.0}, "", {Clip{Rectangle{10.0, 5.0, 80.0, 40.0}}, Clip{}}};
    const std::string figure = svg(drawing);
    EXPECT_EQ(test::markup_fault(figure), "");
    EXPECT_NE(figure.find("<svg x=\"10\" y=\"5\" width=\"80\" height=\"40\" viewBox=\"10 5 80 40\" "
                          "overflow=\"hidden\">\n</svg>\n</svg>\n"),
              std::string::npos)
        << figure;
}

TEST(SvgDocument, HasASizeOnlyAsAFileOfItsOwnAndAlwaysAName) {
    Drawing drawing{{3.0, 4.0, 100.0, 50.5}, "", {}};
    const std::string column = svg(drawing), file = svg(drawing, true);
    EXPECT_EQ(column.find(" width="), std::string::npos);
    EXPECT_NE(file.find(" width=\"100\" height=\"50.5\" viewBox=\"3 4 100 50.5\""), std::string::npos);
    EXPECT_NE(column.find(" viewBox=\"3 4 100 50.5\""), std::string::npos);
    EXPECT_NE(column.find("aria-label=\"figure\""), std::string::npos);
    drawing.title = "force & time";
    EXPECT_NE(svg(drawing).find("aria-label=\"force &amp; time\""), std::string::npos);
}

TEST(SvgDocument, RoundsToAHundredthOfAPixelAndBoundsTheRest) {
    EXPECT_EQ(written(Stroke{{{1.0 / 3.0, 1e9}, {-0.001, -1e300}}, red}),
              "<line x1=\"0.33\" y1=\"0\" x2=\"100000\" y2=\"-100000\" stroke=\"#d00010\" stroke-width=\"1\"/>\n");
}

TEST(Colours, AreReadBackFromTheirText) {
    for (const char* text : {"#000000", "#ffffff", "#0072b2", "#09af90", "#a1b2c3"}) {
        EXPECT_EQ(hex_of(colour_of(text)), text);
        EXPECT_EQ(colour_of(text).opacity, 1.0);
    }
    EXPECT_EQ(colour_of("#010203").rgb, 0x010203u);
    // Twice faded is faded by the product, and the colour stays.
    EXPECT_EQ(faded(faded(red, 0.5), 0.5), (Colour{red.rgb, 0.25}));
}

TEST(Colours, OfSlotsRepeatAndInkIsThatOfText) {
    const Palette& palette = print_palette();
    const auto count = static_cast<int>(palette.series.size());
    for (int i = 0; i < count; ++i) {
        EXPECT_EQ(palette.slot(i), palette.series[static_cast<std::size_t>(i)]);
        EXPECT_EQ(palette.slot(i + 2 * count), palette.slot(i));
        EXPECT_FALSE(palette.slot(i) == palette.text);
    }
    EXPECT_EQ(palette.slot(ink_colour), palette.text);
}

}  // namespace
}  // namespace myo::chart::svg_marks_test
