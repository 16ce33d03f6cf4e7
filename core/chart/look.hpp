#pragma once

#include <map>
#include <string>

#include "chart/layout.hpp"

namespace myo::chart {

/// Slots of automatic colours by name: equal names have equal colours in all panels.
std::map<std::string, int> slots_of_names(const Chart& chart);

/// Colour and style of a series, as its legend entry shows them.
///
/// @param slots  of the chart that the series belongs to, from slots_of_names()
LegendEntry look_of(const Series& series, const std::map<std::string, int>& slots, const Palette& palette);

}  // namespace myo::chart
