#pragma once

#include <limits>
#include <string>

#include "chart/chart.hpp"
#include "chart/ticks.hpp"

namespace myo::chart {

/// Maps values of an axis to pixels and back.
struct Scale {
    double lowest = 0.0;
    double highest = 1.0;
    double from_px = 0.0;  // pixel of `lowest`
    double to_px = 1.0;    // pixel of `highest`; below from_px for a vertical axis, as pixels grow downwards
    bool logarithmic = false;
    /// Pixel of a value, not clipped to the axis; not finite if the value cannot be drawn.
    double operator()(double value) const;
    /// Value at a pixel, inside of the axis or beyond; inverse of operator().
    double value(double pixel) const;
    /// Range of values between the pixels `from` and `to`, in ascending order.
    Range range(double from, double to) const;
    /// Visible range.
    Range range() const { return {lowest, highest}; }
};

/// Ticks and scale of an axis.
struct PlannedAxis {
    Ticks ticks;
    Scale scale;
};

/// Smallest and largest finite value added (positive values only for a logarithmic axis).
struct DataRange {
    explicit DataRange(const Axis& axis) : logarithmic(axis.logarithmic) {}
    bool logarithmic;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    /// Extends the range by a value; values that cannot be drawn are ignored.
    void add(double value);
};

/// Range of an axis, its ticks and its scale. Categories have one tick each and ignore a given range.
///
/// @param padding         fraction of the data range added on both sides, unless the range is given
/// @param from_px, to_px  pixels of the ends; from_px > to_px for a vertical axis
/// @param tick_px         distance of neighbouring ticks, about [px]
PlannedAxis plan_axis(const Axis& axis, const DataRange& data, double padding, double from_px, double to_px,
                      double tick_px);

/// Removes labels that would overlap. Of linear ticks every second, fifth or tenth keeps its label, counted from zero,
/// or the two outermost ones if fewer than two would remain. Ticks stay.
///
/// @param needed_px  smallest distance of two labels [px]
void thin_labels(PlannedAxis& axis, double needed_px);

/// Axis title with factor and unit, e.g. "label [10⁻³ m]".
std::string axis_title(const Axis& axis, const Ticks& ticks);

}  // namespace myo::chart
