#pragma once

#include <string>
#include <vector>

#include "prediction/marker_places.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"

// Places of the markers that a fit found, where markers.placement_m leaves them open.

namespace myo::results {

/// Lines of a table in mm with a line end before each; empty if the places are exact.
std::string place_lines(const std::vector<prediction::FoundPlace>& places);

/// Per marker: shift_m and std_m, three numbers each, and distance_m.
report::Json places_json(const std::vector<prediction::FoundPlace>& places);

/// Table of the places in mm with standard deviations.
///
/// @param placement_m  1 sigma that the places were given
report::Section places_section(const std::vector<prediction::FoundPlace>& places, double placement_m);

}  // namespace myo::results
