#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "chart/decimate.hpp"
#include "chart/layout.hpp"

namespace myo::chart {

/// A chart as marks in pixels. Back ends draw marks and decide nothing: svg() and the window's draw list.

/// Filled rectangle.
struct Box {
    Rectangle area;
    Colour colour;
    double radius = 0.0;  // of the corners
};

/// Curve with gaps (NaN).
struct Stroke {
    Polyline points;
    Colour colour;
    double width = 1.0;
    double dash = 0.0;  // length of a dash; 0: solid
    double gap = 0.0;   // length between dashes
};

/// Closed area between two curves with gaps (NaN).
struct Band {
    std::vector<double> x, upper, lower;  // same length
    Colour colour;
};

/// Round dots; NaN: none.
struct Dots {
    Polyline centres;
    Colour colour;
    double diameter = 1.0;
};

/// Filled polygon with an edge.
struct Polygon {
    Polyline corners;
    Colour fill;
    Colour edge;
    double width = 1.0;  // of the edge
};

/// Horizontal alignment of text relative to its position.
enum class Anchor { start, middle, end };

/// A line of text.
struct Text {
    Point at;  // end named by the anchor; vertical middle of the letters
    std::string text;
    Colour colour;
    double size = 11.0;  // font size
    Anchor anchor = Anchor::start;
    bool bold = false;
    std::optional<Colour> halo = std::nullopt;  // outline, for text over curves
    double turned = 0.0;                        // clockwise [degrees]
};

/// From here on marks are cut at an area; without area no longer.
struct Clip {
    std::optional<Rectangle> area;
};

using Mark = std::variant<Box, Stroke, Band, Dots, Polygon, Text, Clip>;

/// Marks in the order of drawing.
struct Drawing {
    Rectangle frame;    // of the whole picture
    std::string title;  // for readers who do not see it
    std::vector<Mark> marks;
};

/// Marks of a chart in its layout. Curves are reduced to what is visible: cut at the ends of the x axis, and at most
/// four points per half pixel.
Drawing draw(const Chart& chart, const Layout& layout, const Palette& palette);

/// Marks of a legend entry in its place: a sample of its look, then its name.
void draw_legend_entry(const PlacedEntry& placed, const LayoutStyle& style, const Palette& palette, Drawing& drawing);

}  // namespace myo::chart
