#pragma once

#include <optional>
#include <string_view>

namespace myo::measurement {

/// Metres per unit of length from the unit's name in files ("mm", "Meters", "in"); nullopt if unknown.
std::optional<double> metres_per_unit(std::string_view name);

}  // namespace myo::measurement
