#include "commands/typed_quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace myo::ui {
namespace {

using commands::Dimension;
using commands::edited_text;
using commands::parse_quantity;
using commands::QuantityRange;

/// What a field makes of a text: a value or a sentence.
struct Entry {
    const char* text;
    double value;
    const char* sentence;
};

constexpr double refused = std::numeric_limits<double>::quiet_NaN();

void expect_entries(const QuantityRange& range, const std::vector<Entry>& entries) {
    for (const Entry& entry : entries) {
        const Result<double> accepted = commands::accept_quantity(entry.text, range);
        if (std::isnan(entry.value)) {
            ASSERT_FALSE(accepted) << "'" << entry.text << "' became " << *accepted;
            EXPECT_EQ(accepted.error().what, entry.sentence);
        } else {
            ASSERT_TRUE(accepted) << accepted.error().what;
            EXPECT_EQ(*accepted, entry.value) << "'" << entry.text << "'";
        }
    }
}

TEST(TypedQuantity, AYoungsModulusHasUnitsAndEitherDecimalMark) {
    expect_entries(
        {Dimension::pressure, "kPa", "Young's modulus", commands::youngs_modulus_limits},
        {{"260", 2.6e5, ""},
         {"1,5 MPa", 1.5e6, ""},
         {"1.5MPa", 1.5e6, ""},
         {" 0.3 MPa ", 3e5, ""},
         {".5 GPa", 5e8, ""},
         {"12 mbar", 1200.0, ""},
         {"2 bar", 2e5, ""},
         {"1 200", 1.2e6, ""},
         {"1 200,5 kPa", 1200500.0, ""},
         {"1e3", 1e6, ""},
         {"1.1e-3 GPa", 1.1e6, ""},
         {"5e5 N/m²", 5e5, ""},
         {"0,3 N/mm^2", 3e5, ""},
         {"9 GPa", refused, "9 GPa is above the highest Young's modulus, 1000000 kPa"},
         {"200 mPa", refused, "200 mPa is below the lowest Young's modulus, 0.1 kPa"},
         {"-5", refused, "-5 is below the lowest Young's modulus, 0.1 kPa"},
         {"\xe2\x88\x92"
          "5",
          refused, "-5 is below the lowest Young's modulus, 0.1 kPa"},
         {"1,5 mpa", refused, "'mpa' is not a unit of pressure: write MPa, where capitals matter"},
         {"260 kpa", refused, "'kpa' is not a unit of pressure: write kPa, where capitals matter"},
         {"260 mm", refused, "'mm' is not a unit of pressure: use Pa, kPa, MPa, GPa, bar, mbar or psi"},
         {"1,000.5", refused, "'1,000.5' has several separators: write thousands without one, such as 1000.5"},
         {"1.000.000", refused, "'1.000.000' has several separators: write thousands without one, such as 1000.5"},
         {"1,250", refused, "'1,250' can be read in two ways: write 1.250 or 1250"},
         {"abc", refused, "'abc' is not a number"},
         {"kPa", refused, "'kPa' is not a number"},
         {"", refused, "Nothing is typed: a number is needed"},
         {"  ", refused, "Nothing is typed: a number is needed"},
         {"nan", refused, "'nan' is not a number"},
         {"inf", refused, "'inf' is not a number"},
         {"1e400", refused, "'1e400' is too large or too small a number"},
         {"1e99999999999", refused, "'1e99999999999' is too large or too small a number"},
         {"0x10", refused, "'x10' is not a unit of pressure: use Pa, kPa, MPa, GPa, bar, mbar or psi"},
         {"--5", refused, "'--5' is not a number"},
         {"5-3", refused, "'5-3' is not a number"},
         {"1 20", refused, "'1 20' is not a number"},
         {"1/3", refused, "'/3' is not a unit of pressure: use Pa, kPa, MPa, GPa, bar, mbar or psi"}});
}

TEST(TypedQuantity, ALengthIsInMillimetresUnlessItHasAUnit) {
    expect_entries({Dimension::length, "mm", "edge length", {0.1 / 120.0, 0.1 / 3.0}},
                   {{"20 mm", 0.02, ""},
                    {"5", 0.005, ""},
                    {"1.1", 0.0011, ""},
                    {"0,5 cm", 0.005, ""},
                    {"0.003 m", 0.003, ""},
                    {"900 um", 9e-4, ""},
                    {"900 µm", 9e-4, ""},
                    {"1 in", 0.0254, ""},
                    {"2o mm", refused, "'2o mm' is not a number"},
                    {"5 kg", refused, "'kg' is not a unit of length: use m, cm, mm or um"},
                    {"5 MM", refused, "'MM' is not a unit of length: write mm, where capitals matter"},
                    {"5 5 mm", refused, "'5 5 mm' is not a number"},
                    {"20 cm", refused, "20 cm is above the highest edge length, 33.33 mm"},
                    {"0", refused, "0 is below the lowest edge length, 0.8334 mm"}});
}

TEST(TypedQuantity, RatiosTimesRatesAndDensities) {
    expect_entries({Dimension::ratio, "", "Poisson's ratio", commands::poissons_ratio_limits},
                   {{"0,49", 0.49, ""},
                    {"49 %", 0.49, ""},
                    {"0.4999", 0.4999, ""},
                    {"0.6", refused, "0.6 is above the highest Poisson's ratio, 0.4999"},
                    {"0,4 Pa", refused, "'Pa' is not a unit of ratios: use % or no unit"}});
    expect_entries({Dimension::time, "ms", "time step", commands::time_step_limits},
                   {{"10", 0.01, ""},
                    {"0,02 s", 0.02, ""},
                    {"500 us", 5e-4, ""},
                    {"1 min", refused, "1 min is above the highest time step, 100 ms"},
                    {"1 S", refused, "'S' is not a unit of time: write s, where capitals matter"}});
    expect_entries({Dimension::frequency, "1/s", "Λ", commands::velocity_force_limits},
                   {{"-1,5", -1.5, ""}, {"5 1/s", 5.0, ""}, {"5/s", 5.0, ""}, {"7.75 Hz", 7.75, ""}});
    expect_entries({Dimension::density, "kg/m³", "density", commands::density_limits},
                   {{"1070", 1070.0, ""},
                    {"1,07 g/cm3", 1070.0, ""},
                    {"1.07 g/cm³", 1070.0, ""},
                    {"1070 kg", refused, "'kg' is not a unit of density: use kg/m³ or g/cm³"}});
    expect_entries({Dimension::number, "", "number of evaluations", {1.0, 1000.0}, true},
                   {{"12", 12.0, ""},
                    {"12.5", refused, "12.5 is not a whole number"},
                    {"12 %", refused, "'%' is not expected: this number has no unit"}});
}

TEST(TypedQuantity, OneNameHasAMeaningPerDimension) {
    EXPECT_EQ(*parse_quantity("2 g", Dimension::mass, "kg"), 0.002);
    EXPECT_EQ(*parse_quantity("2 g", Dimension::acceleration, "m/s²"), 2.0 * 9.80665);
    EXPECT_EQ(*parse_quantity("180 °", Dimension::angle, "rad"), M_PI);
    EXPECT_EQ(*parse_quantity("250 ml", Dimension::volume, "m³"), 2.5e-4);
    EXPECT_EQ(*parse_quantity("3 N/mm", Dimension::stiffness, "N/m"), 3000.0);
    EXPECT_EQ(*parse_quantity("20 N mm", Dimension::torque, "N m"), 0.02);
    EXPECT_FALSE(parse_quantity("20 N m", Dimension::force, "N"));
}

TEST(TypedQuantity, TheEditedTextReadsAsTheSameDouble) {
    EXPECT_EQ(edited_text(263824.0, Dimension::pressure, "kPa"), "263.824 kPa");
    EXPECT_EQ(edited_text(0.0011, Dimension::length, "mm"), "1.1 mm");
    EXPECT_EQ(edited_text(0.49, Dimension::ratio, ""), "0.49");
    EXPECT_EQ(edited_text(-0.0, Dimension::ratio, "%"), "0 %");
    EXPECT_EQ(edited_text(1e-30, Dimension::force, "N"), "1e-30 N");
    EXPECT_EQ(commands::displayed_text(1.0 / 3.0, Dimension::length, "mm"), "333.33 mm");
    struct Shown {
        Dimension dimension;
        const char* unit;
    };
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> mantissa(-10.0, 10.0), exponent(-12.0, 12.0);
    for (const Shown& shown :
         {Shown{Dimension::pressure, "kPa"}, Shown{Dimension::pressure, "psi"}, Shown{Dimension::length, "mm"},
          Shown{Dimension::angle, "°"}, Shown{Dimension::time, "min"}, Shown{Dimension::ratio, "%"}})
        for (int i = 0; i < 2000; ++i) {
            const double value = mantissa(random) * std::pow(10.0, exponent(random));
            const std::string text = edited_text(value, shown.dimension, shown.unit);
            const Result<double> read = parse_quantity(text, shown.dimension, shown.unit);
            ASSERT_TRUE(read) << text;
            ASSERT_EQ(*read, value) << text;
        }
}

}  // namespace
}  // namespace myo::ui
