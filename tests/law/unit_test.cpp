#include "law/unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Units as exponents of five base units: their words, their algebra, and names that end in them.

namespace myo::law::unit_test {
namespace {

Unit unit_of_words(const std::string& words) {
    const std::optional<Unit> read = unit_from_words(words);
    EXPECT_TRUE(read) << words;
    return read.value_or(Unit{});
}

/// Definitions of the SI brochure, each by base units.
TEST(UnitWords, HaveTheirBaseUnits) {
    for (const auto& [word, base] : std::vector<std::pair<std::string, std::string>>{{"1", "1"},
                                                                                     {"rad", "1"},
                                                                                     {"m", "m"},
                                                                                     {"kg", "kg"},
                                                                                     {"s", "s"},
                                                                                     {"K", "K"},
                                                                                     {"A", "A"},
                                                                                     {"Hz", "1/s"},
                                                                                     {"N", "m kg/s2"},
                                                                                     {"Pa", "kg/m s2"},
                                                                                     {"J", "m2 kg/s2"},
                                                                                     {"W", "m2 kg/s3"},
                                                                                     {"V", "m2 kg/s3 A"}}) {
        EXPECT_EQ(to_string(unit_of_words(word)), base) << word;
        EXPECT_EQ(unit_of_words(base), unit_of_words(word)) << "what a message says can be written";
    }
    EXPECT_EQ(unit_of_words("W s"), unit_of_words("N m"));
    EXPECT_EQ(unit_of_words("V A"), unit_of_words("J Hz"));
    EXPECT_EQ(unit_of_words("Pa m2"), unit_of_words("N"));
}

TEST(UnitWords, MayBeWrittenInSeveralWays) {
    for (const std::string words : {"N s/m2", "N*s/m2", "s N / m2", "N s/m m", "N s/m/m", "N s m-2", "N s m^-2", "Pa s",
                                    " Pa  s ", "1/Pa-1 Hz", "N s/m^2"})
        EXPECT_EQ(to_string(unit_of_words(words)), "kg/m s") << words;
    for (const std::string words : {"", " ", "1", "rad", "m/m", "Hz s", "m0"})
        EXPECT_TRUE(unit_of_words(words).is_plain()) << words;
}

TEST(UnitWords, AreRefusedWhereOneOfThemIsNone) {
    for (const std::string words : {"kPa", "n", "pa", "Nm", "m/sec", "2", "12 m", "-1", "m--2", "m2m", "g", "%", "m,s",
                                    "m(s)", "°", "deg", "N/mm", "mN"})
        EXPECT_FALSE(unit_from_words(words)) << words;
}

TEST(UnitAlgebra, AddsAndScalesExponents) {
    const Unit pascal = unit_of_words("Pa"), metre = unit_of_words("m");
    EXPECT_EQ(pascal * metre / metre, pascal);
    EXPECT_TRUE((pascal / pascal).is_plain());
    EXPECT_FALSE(pascal.is_plain());
    EXPECT_EQ(to_power(metre, 3.0), metre * metre * metre);
    EXPECT_EQ(to_power(pascal, -1.0), Unit{} / pascal);
    EXPECT_TRUE(to_power(pascal, 0.0).is_plain());
    const Unit root = to_power(pascal, 0.5);
    EXPECT_EQ(root * root, pascal);
    EXPECT_EQ(to_string(root), "kg0.5/m0.5 s");
    EXPECT_EQ(to_string(to_power(metre, 1.5)), "m1.5");
    EXPECT_EQ(to_string(Unit{} / metre), "1/m");
    EXPECT_EQ(to_string(to_power(unit_of_words("V"), -2.0)), "s6 A2/m4 kg2");
}

/// A zero with a sign would still be equal, but no message may show it, and no comparison of bits may differ.
TEST(UnitAlgebra, KeepsZerosWithoutSign) {
    for (const double power : to_power(Unit{}, -1.0).powers) EXPECT_FALSE(std::signbit(power));
    for (const double power : (Unit{} / unit_of_words("kg")).powers) EXPECT_TRUE(power == -1.0 || !std::signbit(power));
}

TEST(UnitNames, EndInTheLongestUnit) {
    for (const auto& [name, words] : std::vector<std::pair<std::string, std::string>>{{"flow_m3_per_s", "m3/s"},
                                                                                      {"density_kg_per_m3", "kg/m3"},
                                                                                      {"angle_rad", "rad"},
                                                                                      {"rate_rad_s", "rad/s"},
                                                                                      {"jerk_m_s3", "m/s3"},
                                                                                      {"energy_J_per_m2", "J/m2"},
                                                                                      {"slope_per_K", "1/K"},
                                                                                      {"gain_Pa_per_V", "Pa/V"},
                                                                                      {"m_kg", "kg"},
                                                                                      {"s", ""},
                                                                                      {"", ""},
                                                                                      {"kg_of_load", ""},
                                                                                      {"gap_mm", ""},
                                                                                      {"level_m_max", ""},
                                                                                      {"k_", ""}}) {
        EXPECT_EQ(unit_of_name(name), words) << name;
        EXPECT_TRUE(unit_from_words(unit_of_name(name))) << name;
    }
}

TEST(UnitNames, ShowEndingsWithAPrefix) {
    for (const std::string ending :
         {"mm", "cm", "km", "um", "ms", "kPa", "MPa", "bar", "mN", "kN", "kHz", "mm2", "cm3"}) {
        EXPECT_EQ(prefixed_ending("value_" + ending), ending);
        EXPECT_EQ(prefixed_ending("value_per_" + ending), ending);
        EXPECT_EQ(prefixed_ending(ending), "") << "a name alone is no ending";
        EXPECT_EQ(prefixed_ending("value_" + ending + "_s"), "") << "only the last part is one";
        EXPECT_FALSE(unit_from_words(ending)) << ending;
    }
    for (const std::string name : {"gap_m", "gap_", "", "mmm", "gap_mmm", "gap_MM"})
        EXPECT_EQ(prefixed_ending(name), "") << name;
}

}  // namespace
}  // namespace myo::law::unit_test
