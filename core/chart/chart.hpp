#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "chart/colour.hpp"

namespace myo::chart {

// A chart is described by data only, so that it can be tested and drawn without a window. lay_out() places it, draw()
// turns it into marks, and svg() or the window draw the marks.

/// Charts as values. Equal values give equal pictures. NaN and infinite samples are gaps.

/// Closed interval on an axis, in the unit of the axis.
struct Range {
    double lowest = 0.0;
    double highest = 1.0;
    double span() const { return highest - lowest; }
    bool operator==(const Range&) const = default;
};

/// Axis of a chart: quantity and unit. The range follows the data unless it is given.
struct Axis {
    std::string label = {};
    std::string unit = {};                         // in brackets after the label; empty: dimensionless
    std::optional<double> lowest = std::nullopt;   // given start of the range
    std::optional<double> highest = std::nullopt;  // given end of the range
    bool logarithmic = false;                      // values <= 0 are gaps
    bool include_zero = false;                     // extend the range to zero
    std::vector<double> include = {};              // values that the range contains at least
    std::vector<std::string> categories = {};      // names at 0, 1, 2, ... instead of numbers
};

/// How a series is drawn. Bars need `ends`; diamonds mark references.
enum class SeriesStyle { line, dashed, dots, line_and_dots, bars, diamonds };

/// Values of Series::colour: slots of Palette::series from 0, or one of these.
enum SeriesColour : int {
    automatic_colour = -1,  // the next slot; equal names have equal colours in all panels
    ink_colour = -2,        // the colour of text, for measured data
};

/// A curve with its style.
struct Series {
    std::string name = {};       // legend entry; empty: not listed
    std::vector<double> x = {};  // same length as y
    std::vector<double> y = {};
    SeriesStyle style = SeriesStyle::line;
    int colour = automatic_colour;
    std::vector<double> half_width = {};  // pale band y ± half_width; empty or same length as y
    std::vector<Range> ends = {};         // bars: their ends in x; other styles: intervals in x, NaN for none
    std::optional<Colour> own_colour = std::nullopt;  // instead of a slot
    bool hidden = false;                              // not drawn; its legend entry is pale
};

/// Thin line across the panel at one value, with a label.
struct ReferenceLine {
    double value = 0.0;
    std::string label = {};
};

/// Shaded interval of the x axis, e.g. a fit window or a load.
struct Span {
    double from = 0.0;
    double to = 0.0;
    std::string label = {};
};

/// Remark at the left edge of a panel, e.g. "no value".
struct Note {
    double y = 0.0;
    std::string text = {};
};

/// One coordinate system of a chart.
struct Panel {
    Axis y = {};
    std::vector<Series> series = {};
    double height_px = 240.0;
    std::vector<ReferenceLine> horizontal = {};
    std::vector<ReferenceLine> vertical = {};
    std::vector<Span> spans = {};
    std::vector<Note> notes = {};
};

/// Curves in one or several panels with a common x axis, from top to bottom.
struct Chart {
    std::string title = {};
    Axis x = {};
    std::vector<Panel> panels = {};
    double width_px = 760.0;
    bool legend = true;    // from the number of entries on that the style of the layout names
    bool x_labels = true;  // tick labels and title of the x axis; false if the chart below shows them
};

/// Values of one legend entry, one bar per category.
struct BarGroup {
    std::string name = {};            // legend entry, shown if there are several groups
    std::vector<double> values = {};  // one per category; NaN: no bar
};
/// Bars of several groups side by side in each category, from zero.
struct BarChart {
    std::string title = {};
    std::vector<std::string> categories = {};
    Axis y = {};
    std::vector<BarGroup> groups = {};
    double width_px = 760.0;
    double height_px = 260.0;
};
/// Chart of bars. Asserts one value per category and group.
Chart chart_of(const BarChart& bars);

/// Counts in bins; bin i is [edges[i], edges[i + 1]].
struct Histogram {
    std::string title = {};
    Axis x = {};
    std::vector<double> edges = {};  // ascending, one more than counts
    std::vector<double> counts = {};
    std::string count_label = "count";
    std::vector<ReferenceLine> vertical = {};
    double width_px = 760.0;
    double height_px = 240.0;
};
/// Chart of a histogram. Asserts one edge more than counts, or neither.
Chart chart_of(const Histogram& histogram);

/// Histogram of the finite samples with equal bins and round edges. Values beyond 1e150 are omitted.
///
/// @param wanted_bins  approximate number of bins; 0: rule of Freedman & Diaconis, 5 to 60
Histogram histogram_of(const std::vector<double>& samples, int wanted_bins = 0);

/// Row of an ErrorBarChart: estimate, its interval, and a reference such as the true or the start value.
struct ErrorBarRow {
    std::string name = {};
    double value = 0.0;
    double lowest = std::numeric_limits<double>::quiet_NaN();   // start of the interval; NaN: none
    double highest = std::numeric_limits<double>::quiet_NaN();  // end of the interval; NaN: none
    std::optional<double> reference = std::nullopt;             // shown as a diamond
};
/// Estimates with intervals, one per row.
struct ErrorBarChart {
    std::string title = {};
    Axis x = {};
    std::vector<ErrorBarRow> rows = {};  // from top to bottom
    std::string reference_name = {};     // legend entry of the references; empty: no legend
    std::vector<ReferenceLine> vertical = {};
    double width_px = 760.0;
};
/// Chart of estimates with intervals. Rows whose estimate is not seen carry a remark.
Chart chart_of(const ErrorBarChart& chart);

}  // namespace myo::chart
