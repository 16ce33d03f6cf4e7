#pragma once

#include <array>
#include <optional>
#include <string>

namespace myo::law {

/// Exponents of metre, kilogram, second, kelvin and ampere; roots make fractions.
struct Unit {
    std::array<double, 5> powers{};

    bool operator==(const Unit&) const = default;
    bool is_plain() const { return *this == Unit{}; }
};
Unit operator*(const Unit& a, const Unit& b);
Unit operator/(const Unit& a, const Unit& b);
Unit to_power(const Unit& unit, double exponent);

/// Unit from words: "Pa s/m", "kg/m3", "1/s", "m/s^2"; empty text is a plain number.
/// @return  nullopt if a word is no SI unit without a prefix
std::optional<Unit> unit_from_words(const std::string& words);

/// Words of the unit that a name ends in: "coefficient_kg_m3" in "kg/m3", "stiffness_N_per_m" in "N/m"; empty: none.
std::string unit_of_name(const std::string& name);
/// Unit with a prefix in which a name ends ("mm" of gap_mm); empty: none.
std::string prefixed_ending(const std::string& name);

/// The unit by base units, for messages: "kg m/s2"; "1" of a plain number.
std::string to_string(const Unit& unit);

}  // namespace myo::law
