#pragma once

#include <vector>

namespace myo::prediction {

/// Monotone cubic interpolation, extrapolated linearly with the end slopes.
///
/// @param x, y           points, x strictly ascending, at least one
/// @param value_at_zero  second point (0, value_at_zero) if only one point is given: the curve is then a straight line
/// @return               value at `at`
/// Source: Fritsch & Butland 1984 (slopes).
double curve_through(const std::vector<double>& x, const std::vector<double>& y, double at, double value_at_zero);

}  // namespace myo::prediction
