#pragma once

#include <limits>

namespace myo::test {

// What a run that broke down may hand to a page.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                        infinity = std::numeric_limits<double>::infinity();

}  // namespace myo::test
