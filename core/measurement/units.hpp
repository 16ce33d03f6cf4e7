#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.hpp"

namespace myo::measurement {

/// Units of length of experiment files with their metres.
inline constexpr std::array<std::pair<const char*, double>, 5> length_units{
    {{"m", 1.0}, {"dm", 1e-1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}};

/// Units of time of experiment files with their seconds.
inline constexpr std::array<std::pair<const char*, double>, 4> time_units{
    {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}}};

/// Metres per unit of length from the unit's name in files ("mm", "Meters", "in"); nullopt if unknown.
std::optional<double> metres_per_unit(std::string_view name);

/// Word of the unit nearest to so many metres, "mm" for 1.1e-3. The factor between the two is at most `within`;
/// otherwise empty.
std::string unit_word(double metres, double within = 1.001);

/// Metres per unit of a recording: the unit that the file names, or the declared one if the file names none or an
/// unknown one.
///
/// @param field     name of the field in the file, for messages: "POINT:UNITS"
/// @param stated    its content; empty if it is missing
/// @param declared  metres per unit by the key `unit`
/// @param where     place of the field
/// Errors: neither is known; the two differ.
Result<double> recording_unit(const std::string& field, const std::string& stated, std::optional<double> declared,
                              const std::string& where);

}  // namespace myo::measurement
