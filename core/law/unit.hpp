#pragma once

#include <array>
#include <optional>
#include <string>

namespace myo::law {

/// Exponents of metre, kilogram, second, kelvin and ampere; roots make fractions.
struct Unit {
    std::array<double, 5> powers{};  // of m, kg, s, K, A

    bool operator==(const Unit&) const = default;
    bool is_plain() const { return *this == Unit{}; }
};
/// Units of a product, a quotient and a power of quantities. Scales do not occur: all units are SI without prefixes.
Unit operator*(const Unit& a, const Unit& b);
Unit operator/(const Unit& a, const Unit& b);
Unit to_power(const Unit& unit, double exponent);

/// Unit from words: "Pa s/m", "kg/m3", "1/s", "m/s^2"; empty text is a plain number.
/// All factors behind a stroke are below it: "Pa/m s" is Pa/(m s). Angles in rad are plain numbers.
/// @return  nullopt if a word is no SI unit without a prefix
std::optional<Unit> unit_from_words(const std::string& words);

/// Words of the unit that a name ends in: "coefficient_kg_m3" in "kg/m3", "stiffness_N_per_m" in "N/m"; empty: none.
/// Without "per", a length at the end of the name stands below the stroke, and so does a time, except after N, Pa and J
/// ("m_s" is m/s, "Pa_s" is Pa s). The ending "deg" is returned as it is, although unit_from_words() does not know it.
std::string unit_of_name(const std::string& name);
/// Unit with a prefix in which a name ends ("mm" of gap_mm); empty: none. Laws refuse such names.
std::string prefixed_ending(const std::string& name);

/// The unit by base units, for messages: "kg m/s2"; "1" of a plain number.
/// Fractional exponents, which roots make, are written as decimal numbers.
std::string to_string(const Unit& unit);

}  // namespace myo::law
