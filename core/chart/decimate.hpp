#pragma once

#include <cmath>
#include <vector>

namespace myo::chart {

/// Points of a curve in pixels; a NaN point is a gap.
struct Polyline {
    std::vector<double> x;
    std::vector<double> y;
    /// Whether there is a point at index i, no gap.
    bool has_point(std::size_t i) const { return std::isfinite(x[i]) && std::isfinite(y[i]); }
};

/// Reduces a curve to what is visible: of the consecutive points in one pixel column the first, lowest, highest and
/// last are kept, in order. Extremes and gaps are preserved. Curves of fewer than 400 points are returned unchanged.
///
/// @param columns_per_px  columns per pixel; 2 is sufficient for sharp prints
Polyline decimate(const Polyline& curve, double columns_per_px = 2.0);

}  // namespace myo::chart
