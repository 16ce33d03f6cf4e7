#pragma once

#include <vector>

namespace myo::report {

/// Points of a curve in pixels; a point with NaN is a gap.
struct Polyline {
    std::vector<double> x;
    std::vector<double> y;
};

/// Thins a curve to what a picture can show: of each run of points in one pixel column the first, lowest, highest and
/// last stay, in their order. Extremes and gaps survive; a curve that is short already is returned as it is.
///
/// @param columns_per_px  columns per pixel; 2 keeps prints sharp
Polyline decimate(const Polyline& curve, double columns_per_px = 2.0);

}  // namespace myo::report
