#pragma once

#include <vector>

namespace myo::prediction {

/// Monotone cubic curve through points (x ascending, each once), its end slope continued outside.
///
/// One point: a straight line through (0, `value_at_zero`) and it. Two points: the line through them.
/// Source: Fritsch & Butland 1984 (slopes).
double curve_through(const std::vector<double>& x, const std::vector<double>& y, double at, double value_at_zero);

}  // namespace myo::prediction
