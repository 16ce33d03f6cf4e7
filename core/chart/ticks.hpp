#pragma once

#include <string>
#include <vector>

namespace myo::chart {

/// Range, tick positions and tick labels of an axis.
struct Ticks {
    double lowest = 0.0;
    double highest = 1.0;
    std::vector<double> values;       // ascending, within [lowest, highest]
    std::vector<std::string> labels;  // of the values divided by `factor`
    std::string factor;               // e.g. "10⁻³" if the labels are scaled, otherwise empty
};

/// Smallest of 1, 2, 5 times a power of ten that is not below `raw`. Asserts that `raw` is positive and finite.
double round_step(double raw);

/// Adjusts [lowest, highest] to a drawable range: finite, and wide enough for distinct ticks. An empty or non-finite
/// range becomes [0, 1].
void make_drawable(double& lowest, double& highest);

/// Round ticks (1, 2 or 5 times a power of ten) within a range, about `wanted` of them, at least two. A drawable range
/// is not changed.
Ticks linear_ticks(double lowest, double highest, int wanted);

/// Ticks at powers of ten within a positive range; with 2 and 5 times these for few decades, and linear ticks for less
/// than one decade without two such values. A range that is not positive becomes [1, 10].
Ticks logarithmic_ticks(double lowest, double highest, int wanted);

}  // namespace myo::chart
