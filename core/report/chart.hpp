#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace myo::report {

/// Figures as values; svg() turns each into one SVG document without width, so that it fills its column.
/// Same value, same text. NaN and infinite samples are gaps; nothing but finite numbers is written.

/// What an axis shows. The range follows the data unless it is given.
struct Axis {
    std::string label = {};
    std::string unit = {};  // in brackets after the label; empty for numbers without unit
    std::optional<double> lowest = std::nullopt;
    std::optional<double> highest = std::nullopt;
    bool logarithmic = false;  // values <= 0 are then gaps
    bool include_zero = false;
};

enum class SeriesStyle { line, dashed, dots, line_and_dots };

/// Colour slots: 0 ... 5 of series_palette, or these.
inline constexpr int automatic_colour = -1;  // the next slot; one name has one colour in all panels
inline constexpr int ink_colour = -2;        // black, for what was measured

struct Series {
    std::string name = {};       // in the legend; empty = not listed
    std::vector<double> x = {};  // same length as y
    std::vector<double> y = {};
    SeriesStyle style = SeriesStyle::line;
    int colour = automatic_colour;
    std::vector<double> half_width = {};  // a pale band y ± half_width; empty or as long as y
};

/// A thin line across the panel at one value, with a word beside it.
struct ReferenceLine {
    double value = 0.0;
    std::string label = {};
};

/// A pale stretch of the x axis (a fit window, a load).
struct Span {
    double from = 0.0;
    double to = 0.0;
    std::string label = {};
};

struct ChartPanel {
    Axis y = {};
    std::vector<Series> series = {};
    double height_px = 240.0;
    std::vector<ReferenceLine> horizontal = {};
    std::vector<ReferenceLine> vertical = {};
    std::vector<Span> spans = {};
};

/// Curves in one panel or in several with a common x axis, from top to bottom.
struct LineChart {
    std::string title = {};
    Axis x = {};
    std::vector<ChartPanel> panels = {};
    double width_px = 760.0;
};
std::string svg(const LineChart& chart);

/// Bars side by side for each category, from zero.
struct BarGroup {
    std::string name = {};            // in the legend when there are several groups
    std::vector<double> values = {};  // one per category; NaN = no bar
};
struct BarChart {
    std::string title = {};
    std::vector<std::string> categories = {};
    Axis y = {};
    std::vector<BarGroup> groups = {};
    double width_px = 760.0;
    double height_px = 260.0;
};
std::string svg(const BarChart& chart);

/// Counts in bins: bin i reaches from edges[i] to edges[i + 1].
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
std::string svg(const Histogram& histogram);

/// Bins finite samples into equal bins with round edges that hold them all. Others are left out.
///
/// @param wanted_bins  about so many; 0 = Freedman–Diaconis, 5 to 60
Histogram histogram_of(const std::vector<double>& samples, int wanted_bins = 0);

/// One estimate per row: a dot, its interval, and a tick where the truth or the start value lies.
struct ErrorBarRow {
    std::string name = {};
    double value = 0.0;
    double lowest = std::numeric_limits<double>::quiet_NaN();  // end of the interval; NaN = none
    double highest = std::numeric_limits<double>::quiet_NaN();
    std::optional<double> reference = std::nullopt;
};
struct ErrorBarChart {
    std::string title = {};
    Axis x = {};
    std::vector<ErrorBarRow> rows = {};  // from top to bottom
    std::string reference_name = {};     // in the legend
    std::vector<ReferenceLine> vertical = {};
    double width_px = 760.0;
};
std::string svg(const ErrorBarChart& chart);

}  // namespace myo::report
