#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace myo::report {

// A figure is described by data only, so that it can be tested and drawn without a window. Layout (margins, ticks,
// legend, clipping) is decided in svg().

/// Figures as values. svg() converts each to one SVG document without fixed width, which fills its column.
/// Equal values give equal text. NaN and infinite samples are gaps; only finite numbers are written.

/// Axis of a chart. The range follows the data unless it is given.
struct Axis {
    std::string label = {};
    std::string unit = {};                         // in brackets after the label; empty: dimensionless
    std::optional<double> lowest = std::nullopt;   // given start of the range
    std::optional<double> highest = std::nullopt;  // given end of the range
    bool logarithmic = false;                      // values <= 0 are gaps
    bool include_zero = false;                     // extend the range to zero
};

/// How a series is drawn.
enum class SeriesStyle { line, dashed, dots, line_and_dots };

/// Values of Series::colour: 0 ... 5 are slots of series_palette, or one of these.
inline constexpr int automatic_colour = -1;  // the next slot; equal names have equal colours in all panels
inline constexpr int ink_colour = -2;        // black, for measured data

/// A curve with its style.
struct Series {
    std::string name = {};       // legend entry; empty: not listed
    std::vector<double> x = {};  // same length as y
    std::vector<double> y = {};
    SeriesStyle style = SeriesStyle::line;
    int colour = automatic_colour;
    std::vector<double> half_width = {};  // pale band y ± half_width; empty or same length as y
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

/// One coordinate system of a line chart.
struct ChartPanel {
    Axis y = {};
    std::vector<Series> series = {};
    double height_px = 240.0;
    std::vector<ReferenceLine> horizontal = {};
    std::vector<ReferenceLine> vertical = {};
    std::vector<Span> spans = {};
};

/// Curves in one or several panels with a common x axis, from top to bottom.
struct LineChart {
    std::string title = {};
    Axis x = {};
    std::vector<ChartPanel> panels = {};
    double width_px = 760.0;
};
/// SVG document of a line chart. Asserts equal lengths of x, y and half_width.
std::string svg(const LineChart& chart);

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
/// SVG document of a bar chart. Asserts one value per category.
std::string svg(const BarChart& chart);

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
/// SVG document of a histogram.
std::string svg(const Histogram& histogram);

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
/// SVG document of an error bar chart.
std::string svg(const ErrorBarChart& chart);

}  // namespace myo::report
