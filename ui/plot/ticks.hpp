#pragma once

#include <string>
#include <vector>

namespace myo::ui::plot {

struct Range {
    double lowest = 0.0;
    double highest = 1.0;

    double span() const { return highest - lowest; }
    bool operator==(const Range&) const = default;
};

/// The smallest of 1, 2, 5 times a power of ten that is at least `step`. Asserts step > 0.
double nice_step(double step);

struct Ticks {
    double step = 1.0;
    std::vector<double> values;  // ascending multiples of step inside the range
};

/// At most `most` ticks at nice multiples; none for an empty or non-finite range.
Ticks make_ticks(const Range& range, int most);

/// The value with as many decimals as the step needs; a true minus sign; never "-0".
std::string tick_label(double value, double step);

/// Value with the given number of significant digits, a true minus sign, "-" when not finite.
std::string value_label(double value, int significant_digits);

/// "1.23 mm", of metres.
std::string millimetres(double metres);

/// As value_label without trailing zeros: "30", "0.25".
std::string plain_label(double value, int significant_digits);

/// Both numbers with the decimals that the deviation supports; the value alone when the deviation is unknown.
std::string label_with_deviation(double value, double deviation);

/// Smallest range around all finite values; [0, 1] when there are none.
Range range_of(const std::vector<const double*>& starts, const std::vector<long>& counts);

/// Grown by `part` of the span on each side; a range without extent gets one.
Range padded(const Range& range, double part);

/// Scaled about `fixed` by `factor`.
Range zoomed(const Range& range, double fixed, double factor);

/// Position of a value between pixel `from` (lowest) and `to` (highest), and back.
double to_pixel(const Range& range, double value, double from, double to);
double from_pixel(const Range& range, double pixel, double from, double to);

}  // namespace myo::ui::plot
