#pragma once

#include <optional>
#include <string_view>

namespace myo::measurement {

/// Metres per unit of a length's name as files spell it ("mm", "Meters", "in"); nothing when it is not known.
std::optional<double> metres_per_unit(std::string_view name);

}  // namespace myo::measurement
