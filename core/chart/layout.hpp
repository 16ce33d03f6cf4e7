#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "chart/scale.hpp"

namespace myo::chart {

/// Where everything of a chart lies. Coordinates in pixels, y downwards.

/// A place of a drawing [px].
struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// Rectangle in pixels.
struct Rectangle {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    /// Pixel of the right edge.
    double right() const { return left + width; }
    /// Pixel of the lower edge.
    double bottom() const { return top + height; }
};

/// Width of a text of a font size [px].
using TextWidth = std::function<double(std::string_view text, double size)>;

/// Estimated width in a common sans-serif font: 0.57 of the font size per letter. Pages use it, as the viewer's font is
/// unknown when the figure is written.
double estimated_text_width(std::string_view text, double size);

/// Sizes and distances of a chart [px], for a page by default.
struct LayoutStyle {
    double text = 11.0;         // font size of tick labels and remarks
    double axis_title = 11.5;   // font size of axis titles
    double title = 14.0;        // font size of the title of the chart
    double legend = 11.5;       // font size of the legend
    double line = 1.6;          // thickness of curves
    double dot = 4.2;           // diameter of a sample
    double grid = 1.0;          // thickness of grid lines and axes
    double left_margin = 30.0;  // of the plot rectangle, at least
    double right_margin = 22.0;
    double title_height = 24.0;      // with title
    double gap = 6.0;                // above the legend and the first panel
    double panel_heading = 24.0;     // above a panel, for the title of its axis
    double x_axis_height = 40.0;     // below the last panel: tick labels and title
    double panel_gap = 8.0;          // below the other panels
    double bare_margin = 4.0;        // instead of heading or labels where there are none
    double x_tick = 80.0;            // distance of ticks side by side, about
    double y_tick = 42.0;            // distance of ticks one above the other, about
    double y_padding = 0.05;         // fraction of the data range above and below the data
    double legend_sample = 22.0;     // width of the sample of a legend entry
    double legend_gap = 18.0;        // between legend entries
    std::size_t fewest_entries = 2;  // in a legend: a single curve is named by its axis
    bool vertical_grid = false;      // grid lines also at the ticks of x
    // For little room: the title of the axis and the legend share the line above the plot, the left margin is fixed so
    // that charts below each other align, tick labels of x carry the unit, and there is no title of x.
    bool compact = false;
};

/// Style of the charts in the window, all sizes times `scale`. `text_px`: font size of the labels.
LayoutStyle compact_style(double text_px, double scale);

/// Entry of a legend: how its series looks.
struct LegendEntry {
    std::string name = {};
    Colour colour = {};
    SeriesStyle style = SeriesStyle::line;
    bool dotted = false;  // line of dots: a colour of the palette is used for the second time
    bool hidden = false;  // pale
    bool interval = false;
};

/// Width of an entry with its sample [px], without the gap to the next one.
double legend_entry_width(const LegendEntry& entry, const LayoutStyle& style, const TextWidth& text_width);

/// A legend entry in its place.
struct PlacedEntry {
    LegendEntry entry;
    Rectangle box;
};

/// One coordinate system in its place.
struct PlacedPanel {
    Rectangle area;  // of the curves
    PlannedAxis y;
};

/// A chart in its place.
struct Layout {
    LayoutStyle style;
    Rectangle frame;  // the whole chart
    Point title;      // left end, vertical middle
    PlannedAxis x;
    std::vector<double> x_label_widths;  // one per tick
    std::vector<PlacedPanel> panels;
    std::vector<PlacedEntry> legend;
    bool turned = false;  // names of categories are rotated, because they are wider than their places
};

/// Places plot rectangles, ticks, labels and legend. Asserts that the lengths of each series agree.
///
/// @param palette  colours of the legend
/// @param origin   upper left corner of the chart
Layout lay_out(const Chart& chart, const LayoutStyle& style, const Palette& palette, const TextWidth& text_width,
               const Point& origin = {});

/// Height that lay_out() adds to the plot rectangle of a chart of one panel without title and wrapped legend [px].
///
/// @param heading   there is an axis title or a legend above the plot
/// @param x_labels  there are labels below the plot
double added_height(const LayoutStyle& style, bool heading, bool x_labels);

}  // namespace myo::chart
