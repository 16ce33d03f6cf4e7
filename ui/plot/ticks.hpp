#pragma once

#include <string>
#include <vector>

namespace myo::ui::plot {

/// A closed interval on an axis, in the unit of the axis.
struct Range {
    double lowest = 0.0;
    double highest = 1.0;

    double span() const { return highest - lowest; }
    bool operator==(const Range&) const = default;
};

/// Returns the smallest of 1, 2 or 5 times a power of ten that is not below `step`. Asserts that step is positive and
/// finite.
double nice_step(double step);

/// Positions of grid lines and labels on an axis.
struct Ticks {
    double step = 1.0;
    std::vector<double> values;  // ascending multiples of step inside the range
};

/// Returns at most `most` ticks at multiples of a nice step. Returns no ticks if the range is empty, not finite, or
/// below the resolution of its numbers.
Ticks make_ticks(const Range& range, int most);

/// Formats a tick with as many decimals as the step requires. Uses the minus sign U+2212, and never prints "-0".
std::string tick_label(double value, double step);

/// Formats a value with the given number of significant digits. Returns an en dash if the value is not finite.
std::string value_label(double value, int significant_digits);

/// Formats a length given in metres as millimetres with three significant digits: "1.23 mm".
std::string millimetres(double metres);

/// As value_label(), but without trailing zeros: "30", "0.25".
std::string plain_label(double value, int significant_digits);

/// Formats a value and its standard deviation with the decimals that the deviation justifies: "12.3 ± 0.4". Without a
/// known, positive deviation returns the value alone.
std::string label_with_deviation(double value, double deviation);

/// Returns the smallest range around all finite values. Returns [0, 1] if there are none.
///
/// @param starts, counts  the arrays, same length; the values are not copied
Range range_of(const std::vector<const double*>& starts, const std::vector<long>& counts);

/// Extends a range by `part` of its span on each side. A range without extent gets a small one.
Range padded(const Range& range, double part);

/// Scales a range by `factor` about the value `fixed`, which keeps its position. A factor below 1 zooms in.
Range zoomed(const Range& range, double fixed, double factor);

/// Maps a value to a pixel between `from` (at range.lowest) and `to` (at range.highest), and back. `from` may be
/// greater than `to`. The range must have a span.
double to_pixel(const Range& range, double value, double from, double to);
double from_pixel(const Range& range, double pixel, double from, double to);

}  // namespace myo::ui::plot
