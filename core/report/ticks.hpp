#pragma once

#include <string>
#include <vector>

namespace myo::report {

/// Range, tick positions and their labels of one axis.
struct Ticks {
    double lowest = 0.0;
    double highest = 1.0;
    std::vector<double> values;       // ascending, inside [lowest, highest]
    std::vector<std::string> labels;  // values divided by `factor`
    std::string factor;               // "10⁻³" when the labels are scaled, else empty
};

/// A drawable range around [lowest, highest]: finite, and wide enough for ticks that differ. An empty or non-finite
/// range becomes [0, 1].
void make_drawable(double& lowest, double& highest);

/// Round ticks (1, 2 or 5 times a power of ten) inside a range, about `wanted` of them, at least two. The range is kept
/// when it is drawable.
Ticks linear_ticks(double lowest, double highest, int wanted);

/// Ticks at powers of ten inside a positive range, with 2 and 5 in between when there are few decades, and at equal
/// distances of the value when there is less than that.
Ticks logarithmic_ticks(double lowest, double highest, int wanted);

}  // namespace myo::report
