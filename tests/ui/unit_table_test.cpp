#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "commands/typed_quantity.hpp"

// The table of units, and the limits of number fields. Texts that people type are in typed_quantity_test.cpp.

namespace myo::ui::unit_table {
namespace {

using commands::accept_quantity;
using commands::Dimension;
using commands::find_unit;
using commands::parse_quantity;

struct KnownUnit {
    Dimension dimension;
    const char* name;
    int exponent;         // of ten
    double factor = 1.0;  // besides
};

/// From the definitions: an inch is 25.4 mm, a pound 0.45359237 kg, standard gravity 9.80665 m/s².
std::vector<KnownUnit> known_units() {
    using enum Dimension;
    constexpr double inch = 0.0254, gravity = 9.80665, pound = 0.45359237, turn = 2.0 * std::numbers::pi;
    return {{ratio, "%", -2},
            {ratio, "x", 0},
            {length, "cm", -2},
            {length, "mm", -3},
            {length, "um", -6},
            {length, "dm", -1},
            {length, "in", 0, inch},
            {angle, "°", 0, turn / 360.0},
            {angle, "deg", 0, turn / 360.0},
            {time, "ms", -3},
            {time, "us", -6},
            {time, "min", 0, 60.0},
            {frequency, "kHz", 3},
            {frequency, "1/s", 0},
            {frequency, "1/ms", 3},
            {mass, "g", -3},
            {mass, "mg", -6},
            {mass, "t", 3},
            {density, "g/cm³", 3},
            {density, "kg/l", 3},
            {density, "t/m³", 3},
            {force, "mN", -3},
            {force, "kN", 3},
            {torque, "N mm", -3},
            {torque, "Nm", 0},
            {pressure, "kPa", 3},
            {pressure, "MPa", 6},
            {pressure, "GPa", 9},
            {pressure, "bar", 5},
            {pressure, "mbar", 2},
            {pressure, "hPa", 2},
            {pressure, "mPa", -3},
            {pressure, "N/mm²", 6},
            {pressure, "psi", 0, pound * gravity / (inch * inch)},
            {acceleration, "mm/s²", -3},
            {acceleration, "g", 0, gravity},
            {velocity, "cm/s", -2},
            {velocity, "mm/s", -3},
            {volume, "l", -3},
            {volume, "mL", -6},
            {volume, "cm³", -6},
            {volume, "mm³", -9},
            {stiffness, "N/mm", 3},
            {stiffness, "kN/m", 3}};
}

TEST(UnitTable, EveryUnitHasItsValueAndIsRoundedOnce) {
    for (const KnownUnit& known : known_units()) {
        const commands::Unit* const unit = find_unit(known.dimension, known.name);
        ASSERT_TRUE(unit) << known.name;
        EXPECT_NEAR(unit->si() / (known.factor * std::pow(10.0, known.exponent)), 1.0, 1e-14) << known.name;
        const std::string typed = std::string("7.3 ") + known.name;
        const Result<double> value = parse_quantity(typed, known.dimension, commands::si_unit(known.dimension).name);
        ASSERT_TRUE(value) << typed << ": " << value.error().what;
        // A power of ten costs no rounding: the nearest double, as the compiler reads it.
        const double decimal = std::strtod(("7.3e" + std::to_string(known.exponent)).c_str(), nullptr);
        const double tolerance = known.factor == 1.0 ? 0.0 : 1e-14;
        EXPECT_NEAR(*value / (decimal * known.factor), 1.0, tolerance) << typed;
    }
}

TEST(UnitTable, EachDimensionBeginsWithItsSiUnit) {
    using enum Dimension;
    const std::vector<std::pair<Dimension, std::string>> si{
        {number, ""},      {ratio, ""},    {length, "m"},     {angle, "rad"},         {time, "s"},
        {frequency, "Hz"}, {mass, "kg"},   {force, "N"},      {torque, "N m"},        {density, "kg/m³"},
        {pressure, "Pa"},  {volume, "m³"}, {velocity, "m/s"}, {acceleration, "m/s²"}, {stiffness, "N/m"}};
    for (const auto& [dimension, name] : si) {
        EXPECT_EQ(commands::si_unit(dimension).name, name);
        EXPECT_EQ(commands::si_unit(dimension).si(), 1.0) << name;
        EXPECT_EQ(*parse_quantity("4.5", dimension, name), 4.5) << name;
        EXPECT_EQ(commands::dimension_of_unit(name), name.empty() ? number : dimension) << name;
    }
}

TEST(UnitTable, OneUnitIsSpelledInSeveralWays) {
    using enum Dimension;
    const commands::Unit* const micrometre = find_unit(length, "um");
    EXPECT_EQ(find_unit(length, "\xc2\xb5m"), micrometre) << "micro sign";
    EXPECT_EQ(find_unit(length, "\xce\xbcm"), micrometre) << "Greek letter";
    for (const char* cubic : {"m3", "m^3"}) EXPECT_EQ(find_unit(volume, cubic), find_unit(volume, "m³")) << cubic;
    for (const char* work : {"N·mm", "N*mm"}) EXPECT_EQ(find_unit(torque, work), find_unit(torque, "N mm")) << work;
    EXPECT_EQ(find_unit(pressure, "N/mm2"), find_unit(pressure, "N/mm²"));
    EXPECT_EQ(find_unit(length, "MM"), nullptr) << "case matters: a megametre is no millimetre";
    EXPECT_EQ(find_unit(pressure, "mm"), nullptr) << "of another dimension";
    EXPECT_EQ(find_unit(length, ""), nullptr) << "a length without a unit is in the shown one";
}

TEST(UnitTable, CapitalsAreForgivenInTheAdviceOnly) {
    using enum Dimension;
    EXPECT_STREQ(commands::find_unit_in_any_case(pressure, "KPA")->name, "kPa");
    EXPECT_STREQ(commands::find_unit_in_any_case(pressure, "mpa")->name, "MPa") << "not the millipascal";
    EXPECT_STREQ(commands::find_unit_in_any_case(density, "KG/M3")->name, "kg/m³");
    EXPECT_EQ(commands::find_unit_in_any_case(pressure, "HPA"), nullptr) << "understood, but not offered";
    EXPECT_EQ(commands::find_unit_in_any_case(length, "kpa"), nullptr);
}

TEST(UnitTable, NamesOfDimensionsAndOffers) {
    using enum Dimension;
    EXPECT_EQ(commands::dimension_of_unit("mbar"), pressure);
    EXPECT_EQ(commands::dimension_of_unit("m/s^2"), acceleration);
    EXPECT_EQ(commands::dimension_of_unit("g"), mass) << "of its two meanings the one of the table that comes first";
    EXPECT_EQ(commands::dimension_of_unit("furlong"), number);
    EXPECT_EQ(commands::offered_units(number), "");
    EXPECT_EQ(commands::offered_units(ratio), "%");
    EXPECT_EQ(commands::offered_units(angle), "rad or °");
    EXPECT_EQ(commands::offered_units(acceleration), "m/s², mm/s² or g");
    EXPECT_EQ(commands::offered_units(volume), "m³, l, ml, cm³ or mm³");
}

/// Whether a text is accepted, at and beside the limits.
bool accepted(const std::string& text, const commands::QuantityRange& range) {
    return accept_quantity(text, range).has_value();
}

TEST(QuantityRange, BothLimitsBelongToIt) {
    const commands::QuantityRange range{Dimension::pressure, "kPa", "modulus", {2e4, 3e5}};
    for (const char* inside : {"20", "300", "20 kPa", "0.3 MPa", "3 bar", "20.000000001"})
        EXPECT_TRUE(accepted(inside, range)) << inside;
    for (const char* outside : {"19.999999999", "300.000000001", "0.19 bar", "-20", "0"})
        EXPECT_FALSE(accepted(outside, range)) << outside;
    const commands::QuantityRange one{Dimension::number, "", "count", {1.0, 1.0}, true};
    EXPECT_TRUE(accepted("1", one));
    EXPECT_TRUE(accepted("1.000", one));
    EXPECT_TRUE(accepted("10e-1", one));
    EXPECT_FALSE(accepted("1.0000001", one));
    EXPECT_FALSE(accepted("2", one));
}

TEST(QuantityRange, TheLimitThatAMessageNamesCanBeTyped) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> mantissa(-9.0, 9.0), exponent(-6.0, 6.0), width(0.1, 3.0);
    for (int i = 0; i < 300; ++i) {
        const double lowest = mantissa(random) * std::pow(10.0, std::floor(exponent(random)));
        const double highest = lowest + width(random) * std::abs(lowest);
        const commands::QuantityRange range{Dimension::length, "mm", "edge", {lowest, highest}};
        for (const char* beyond : {"1e30", "-1e30"}) {
            const Result<double> refused = accept_quantity(beyond, range);
            ASSERT_FALSE(refused);
            const std::string sentence = refused.error().what, limit = sentence.substr(sentence.rfind(", ") + 2);
            const Result<double> value = accept_quantity(limit, range);
            ASSERT_TRUE(value) << sentence << " for " << lowest << " to " << highest;
            const double meant = beyond[0] == '-' ? lowest : highest;
            EXPECT_NEAR(*value / meant, 1.0, 1.001e-3) << sentence;
        }
    }
}

}  // namespace
}  // namespace myo::ui::unit_table
