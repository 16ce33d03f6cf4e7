#include "base/text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace myo {
namespace {

TEST(ClosestWord, FindsTheTypingMistake) {
    const std::vector<std::string> keys = {"youngs_modulus_Pa", "poissons_ratio", "density_kg_m3", "damping_s"};
    EXPECT_EQ(closest_word("young_modulus_Pa", keys), "youngs_modulus_Pa");
    EXPECT_EQ(closest_word("dampings", keys), "damping_s");
    EXPECT_EQ(closest_word("poisson_ratio", keys), "poissons_ratio");
    EXPECT_EQ(closest_word("damping_s", keys), "damping_s");
}

TEST(ClosestWord, IsSilentWhenNothingIsNear) {
    EXPECT_EQ(closest_word("colour", {"youngs_modulus_Pa", "damping_s"}), "");
    EXPECT_EQ(closest_word("x", {}), "");
    EXPECT_EQ(closest_word("", {"abc"}), "");
}

TEST(ClosestWord, TakesTheFirstOfEquals) { EXPECT_EQ(closest_word("tip_c", {"tip_a", "tip_b"}), "tip_a"); }

TEST(ParseNumber, TakesWholeTextsOnly) {
    double value = 0.0;
    for (const auto& [text, expected] : std::vector<std::pair<std::string, double>>{{"1", 1.0},
                                                                                    {" -2.5e-3\t", -2.5e-3},
                                                                                    {"+4", 4.0},
                                                                                    {"1e5\r", 1e5},
                                                                                    {".5", 0.5},
                                                                                    {"7.", 7.0},
                                                                                    {"0.1", 0.1}}) {
        ASSERT_TRUE(parse_number(text, value)) << text;
        EXPECT_EQ(value, expected) << text;
    }
    for (const char* text : {"", "  ", "1,5", "1.0 2.0", "1.0x", "abc", "0x10", "--1", "e5", "+", "1e", "1e999", "+-5",
                             "-+5", "inf", "-inf", "infinity"})
        EXPECT_FALSE(parse_number(text, value)) << text;
}

TEST(ParseNumber, ReadsNan) {
    double value = 0.0;
    for (const char* text : {"nan", "NaN", "NAN"}) {
        ASSERT_TRUE(parse_number(text, value)) << text;
        EXPECT_TRUE(std::isnan(value));
    }
}

TEST(FormatNumber, KeepsTheDigitsAskedFor) {
    EXPECT_EQ(format_number(1.23456789), "1.23457");
    EXPECT_EQ(format_number(0.1, 17), "0.10000000000000001");
    EXPECT_EQ(format_number(260000.0, 3), "2.6e+05");
}

TEST(Join, PutsTheSeparatorBetween) {
    EXPECT_EQ(join({"a", "b", "c"}), "a, b, c");
    EXPECT_EQ(join({"a"}, "|"), "a");
    EXPECT_EQ(join({}), "");
}

}  // namespace
}  // namespace myo
