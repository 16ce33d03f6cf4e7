#pragma once

#include <string>
#include <string_view>

namespace myo::ui::commands {

/// What a number field measures. Moduli are pressures; rates (1/s) are frequencies.
enum class Dimension {
    number,  // counts, and whatever has no unit at all
    ratio,
    length,
    angle,
    time,
    frequency,
    mass,
    density,
    force,
    torque,
    pressure,
    acceleration,
    velocity,
    volume,
    stiffness
};

/// A unit of a dimension. Its SI value is factor * 10^exponent; the power of ten is apart, so that decimal prefixes
/// cost no rounding.
struct Unit {
    const char* name;  // as it is shown: "kg/m³"
    Dimension dimension;
    int exponent = 0;
    double factor = 1.0;
    bool offered = true;  // named in messages as one to use

    /// SI value of one unit.
    double si() const;
};

/// The unit of that dimension and name, null if there is none. Case matters; "um" and "µm", "m3", "m^3" and "m³" are
/// the same. The empty name is the unit of plain numbers and ratios.
const Unit* find_unit(Dimension dimension, std::string_view name);

/// As find_unit() among the offered ones, in upper or lower case: "kpa" finds "kPa".
const Unit* find_unit_in_any_case(Dimension dimension, std::string_view name);

/// The SI unit of a dimension; for numbers and ratios the one with the empty name.
const Unit& si_unit(Dimension dimension);

/// Dimension of a unit that is known by its name only; `number` if no dimension has it.
Dimension dimension_of_unit(std::string_view name);

/// Names of the units to use: "m, cm, mm or um"; empty if there are none.
std::string offered_units(Dimension dimension);

}  // namespace myo::ui::commands
