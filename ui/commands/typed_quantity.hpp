#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "commands/settings.hpp"
#include "commands/units.hpp"

namespace myo::ui::commands {

/// SI value of typed text such as "1,5 MPa", "20 mm", "1e-3", ".5" or "1 200". A number without a unit is in the shown
/// one.
///
/// The decimal mark is a point or a comma, thousands may be separated by spaces. The value is rounded once: "1.1 mm" is
/// the double next to 0.0011.
/// Errors: one sentence without a period, such as "'kg' is not a unit of length: use m, cm, mm or um".
Result<double> parse_quantity(std::string_view text, Dimension dimension, std::string_view shown_unit);

/// What a number field accepts.
struct QuantityRange {
    Dimension dimension = Dimension::number;
    std::string unit;           // shown; of this dimension
    std::string quantity;       // in sentences: "Poisson's ratio"
    Limits limits{0.0, 1.0};    // SI, both included
    bool whole_number = false;  // fractions are refused
};

/// As parse_quantity(), and within the range. Nothing is clamped or rounded.
/// Errors: also "0.6 is above the highest Poisson's ratio, 0.4999".
Result<double> accept_quantity(std::string_view text, const QuantityRange& range);

/// Shortest text in the unit for which parse_quantity() returns exactly this value: "263.824 kPa". In units that are no
/// power of ten of the SI unit some values have none; they are written in the SI unit.
///
/// @param value  SI, finite
std::string edited_text(double value, Dimension dimension, std::string_view unit);

/// Text of a field that is not edited: five significant digits and the unit.
///
/// @param value  SI
std::string displayed_text(double value, Dimension dimension, std::string_view unit);

}  // namespace myo::ui::commands
