#include "toml/toml_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "toml/toml_value.hpp"

namespace myo::toml {
namespace {

/// The number that a reader finds where toml_number() wrote.
double reread(double value) {
    const Result<TomlValue> parsed = parse_toml_value(toml_number(value), "here");
    EXPECT_TRUE(parsed) << toml_number(value);
    EXPECT_EQ(parsed->kind, TomlValue::Kind::number) << toml_number(value);
    return parsed->number;
}

TEST(TomlNumber, IsAlwaysAFloat) {
    EXPECT_EQ(toml_number(3.0), "3.0");
    EXPECT_EQ(toml_number(-250000.0), "-250000.0");
    EXPECT_EQ(toml_number(0.1), "0.1");
    EXPECT_EQ(toml_number(0.0), "0.0");
    EXPECT_EQ(toml_number(1e30), "1e+30");
    EXPECT_EQ(toml_number(2.5e-7), "2.5e-07");
}

TEST(TomlNumber, SurvivesToTheLastBit) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> digits(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-300, 300);
    for (int i = 0; i < 2000; ++i) {
        const double value = std::ldexp(digits(random), exponent(random));
        ASSERT_EQ(reread(value), value) << toml_number(value);
    }
    for (const double value : {std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::epsilon(), 1.0 / 3.0, 4e15, 9007199254740993.0})
        EXPECT_EQ(reread(value), value);
}

/// An open end of a load is written as inf.
TEST(TomlNumber, KeepsInfinityAndTheSignOfZero) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(reread(infinity), infinity);
    EXPECT_EQ(reread(-infinity), -infinity);
    EXPECT_TRUE(std::isnan(reread(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_TRUE(std::signbit(reread(-0.0)));
}

TEST(TomlText, EscapesWhatWouldEndTheString) {
    EXPECT_EQ(toml_text("tip"), "\"tip\"");
    EXPECT_EQ(toml_text(""), "\"\"");
    EXPECT_EQ(toml_text("a \"quoted\" word"), R"("a \"quoted\" word")");
    EXPECT_EQ(toml_text("C:\\data"), R"("C:\\data")");
    EXPECT_EQ(toml_text("two\nlines"), R"("two\u000alines")");
    EXPECT_EQ(toml_text("µm"), "\"µm\"");
}

TEST(TomlText, SurvivesAnyCharacter) {
    std::string every;
    for (int c = 1; c < 128; ++c) every += static_cast<char>(c);
    for (const std::string& text : {every, std::string("\\\\\"\\u0041"), std::string("ends with \\"),
                                    std::string("Ångström, 長さ"), std::string("# no comment"), std::string("'''")}) {
        const Result<TomlValue> parsed = parse_toml_value(toml_text(text), "here");
        ASSERT_TRUE(parsed) << toml_text(text);
        EXPECT_EQ(parsed->kind, TomlValue::Kind::text);
        EXPECT_EQ(parsed->text, text);
    }
}

TEST(TomlLists, AreArraysOfTheirItems) {
    EXPECT_EQ(toml_vector({0.1, -2.0, 3e-12}), "[0.1, -2.0, 3e-12]");
    EXPECT_EQ(toml_list(std::vector<double>{}, toml_number), "[]");
    EXPECT_EQ(toml_list(std::vector<std::string>{"a", "b"}, toml_text), R"(["a", "b"])");
    const Result<TomlValue> parsed = parse_toml_value(toml_vector({0.1, 0.2, 0.3}), "here");
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->items.size(), 3u);
    EXPECT_EQ(parsed->items[2].number, 0.3);
}

}  // namespace
}  // namespace myo::toml
