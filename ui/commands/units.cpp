#include "commands/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace myo::ui::commands {
namespace {

/// The units that number fields know. The first one of a dimension is the SI unit.
std::span<const Unit> all_units() {
    using enum Dimension;
    // Entries with `false` are understood, but not named in messages: other spellings and rare units.
    // Source of the factors that are no power of ten: NIST SP 811, appendix B.
    static constexpr std::array table{Unit{"", number},
                                      Unit{"", ratio},
                                      Unit{"%", ratio, -2},
                                      Unit{"×", ratio, 0, 1.0, false},
                                      Unit{"x", ratio, 0, 1.0, false},
                                      Unit{"m", length},
                                      Unit{"cm", length, -2},
                                      Unit{"mm", length, -3},
                                      Unit{"um", length, -6},
                                      Unit{"dm", length, -1, 1.0, false},
                                      Unit{"in", length, 0, 0.0254, false},
                                      Unit{"rad", angle},
                                      Unit{"°", angle, 0, std::numbers::pi / 180.0},
                                      Unit{"deg", angle, 0, std::numbers::pi / 180.0, false},
                                      Unit{"s", time},
                                      Unit{"ms", time, -3},
                                      Unit{"us", time, -6},
                                      Unit{"min", time, 0, 60.0},
                                      Unit{"Hz", frequency},
                                      Unit{"kHz", frequency, 3},
                                      Unit{"1/s", frequency},
                                      Unit{"/s", frequency, 0, 1.0, false},
                                      Unit{"1/ms", frequency, 3, 1.0, false},
                                      Unit{"kg", mass},
                                      Unit{"g", mass, -3},
                                      Unit{"mg", mass, -6},
                                      Unit{"t", mass, 3},
                                      Unit{"kg/m³", density},
                                      Unit{"g/cm³", density, 3},
                                      Unit{"kg/l", density, 3, 1.0, false},
                                      Unit{"t/m³", density, 3, 1.0, false},
                                      Unit{"N", force},
                                      Unit{"mN", force, -3},
                                      Unit{"kN", force, 3},
                                      Unit{"N m", torque},
                                      Unit{"Nm", torque, 0, 1.0, false},
                                      Unit{"N mm", torque, -3},
                                      Unit{"Nmm", torque, -3, 1.0, false},
                                      Unit{"Pa", pressure},
                                      Unit{"kPa", pressure, 3},
                                      Unit{"MPa", pressure, 6},
                                      Unit{"GPa", pressure, 9},
                                      Unit{"bar", pressure, 5},
                                      Unit{"mbar", pressure, 2},
                                      Unit{"psi", pressure, 0, 6894.757293168361},
                                      Unit{"mPa", pressure, -3, 1.0, false},
                                      Unit{"hPa", pressure, 2, 1.0, false},
                                      Unit{"N/m²", pressure, 0, 1.0, false},
                                      Unit{"N/mm²", pressure, 6, 1.0, false},
                                      Unit{"m/s²", acceleration},
                                      Unit{"mm/s²", acceleration, -3},
                                      Unit{"g", acceleration, 0, 9.80665},
                                      Unit{"m/s", velocity},
                                      Unit{"cm/s", velocity, -2},
                                      Unit{"mm/s", velocity, -3},
                                      Unit{"m³", volume},
                                      Unit{"l", volume, -3},
                                      Unit{"ml", volume, -6},
                                      Unit{"cm³", volume, -6},
                                      Unit{"mm³", volume, -9},
                                      Unit{"L", volume, -3, 1.0, false},
                                      Unit{"mL", volume, -6, 1.0, false},
                                      Unit{"N/m", stiffness},
                                      Unit{"N/mm", stiffness, 3},
                                      Unit{"kN/m", stiffness, 3, 1.0, false}};
    return table;
}

/// One spelling for what is typed in several ways.
std::string plain_spelling(std::string_view name) {
    // The micro sign and the Greek mu look the same; products are written with a dot, a star or a blank.
    constexpr std::array<std::array<std::string_view, 2>, 7> spellings{
        {{"²", "2"}, {"³", "3"}, {"^", ""}, {"\xc2\xb5", "u"}, {"\xce\xbc", "u"}, {"·", " "}, {"*", " "}}};
    std::string plain(name);
    for (const auto& [written, replacement] : spellings)
        for (std::size_t at = plain.find(written); at != std::string::npos; at = plain.find(written, at))
            plain.replace(at, written.size(), replacement);
    return plain;
}

}  // namespace

double Unit::si() const { return factor * std::pow(10.0, exponent); }

const Unit* find_unit(Dimension dimension, std::string_view name) {
    const std::string plain = plain_spelling(name);
    const auto found = std::find_if(all_units().begin(), all_units().end(), [&](const Unit& unit) {
        return unit.dimension == dimension && plain_spelling(unit.name) == plain;
    });
    return found != all_units().end() ? &*found : nullptr;
}

const Unit* find_unit_in_any_case(Dimension dimension, std::string_view name) {
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        return text;
    };
    const std::string wanted = lower(plain_spelling(name));
    const auto found = std::find_if(all_units().begin(), all_units().end(), [&](const Unit& unit) {
        return unit.dimension == dimension && unit.offered && lower(plain_spelling(unit.name)) == wanted;
    });
    return found != all_units().end() ? &*found : nullptr;
}

Dimension dimension_of_unit(std::string_view name) {
    const std::string plain = plain_spelling(name);
    const auto found = std::find_if(all_units().begin(), all_units().end(),
                                    [&](const Unit& unit) { return plain_spelling(unit.name) == plain; });
    return found != all_units().end() ? found->dimension : Dimension::number;
}

const Unit& si_unit(Dimension dimension) {
    return *std::find_if(all_units().begin(), all_units().end(),
                         [&](const Unit& unit) { return unit.dimension == dimension; });
}

std::string offered_units(Dimension dimension) {
    std::vector<std::string> names;
    for (const Unit& unit : all_units())
        if (unit.dimension == dimension && unit.offered && unit.name[0] != '\0') names.push_back(unit.name);
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    return list;
}

}  // namespace myo::ui::commands
