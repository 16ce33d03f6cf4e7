#pragma once

#include <vector>

namespace myo::validation {

/// Median of the finite values; NaN if there are none.
double finite_median(std::vector<double> values);

}  // namespace myo::validation
