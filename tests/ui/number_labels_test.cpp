#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "plot/number_text.hpp"

namespace myo::ui::number_labels {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
const std::string dash = "–", minus = "−";

TEST(NumberLabels, AValueKeepsItsSignificantDigits) {
    EXPECT_EQ(plot::value_label(12.341, 3), "12.3");
    EXPECT_EQ(plot::value_label(12.341, 5), "12.341");
    EXPECT_EQ(plot::value_label(0.5, 3), "0.500");
    EXPECT_EQ(plot::value_label(0.0123, 2), "0.012");
    EXPECT_EQ(plot::value_label(1.0, 1), "1");
    EXPECT_EQ(plot::value_label(987654.0, 2), "987654") << "digits before the point are not rounded away";
    EXPECT_EQ(plot::value_label(0.0, 4), "0.000");
}

TEST(NumberLabels, VeryLargeAndVerySmallValuesHaveAPowerOfTen) {
    EXPECT_EQ(plot::value_label(9999999.0, 3), "9999999");
    EXPECT_EQ(plot::value_label(1e7, 3), "1e+07");
    EXPECT_EQ(plot::value_label(-2.5e12, 3), minus + "2.5e+12");
    EXPECT_EQ(plot::value_label(1.1e-5, 3), "0.0000110");
    EXPECT_EQ(plot::value_label(9.9e-6, 3), "9.9e-06");
    EXPECT_EQ(plot::value_label(-9.9e-6, 3), minus + "9.9e-06") << "the sign of the exponent stays a hyphen";
}

TEST(NumberLabels, WhatIsNotFiniteIsADash) {
    for (const double value : {infinite, -infinite, nan}) {
        EXPECT_EQ(plot::value_label(value, 3), dash);
        EXPECT_EQ(plot::plain_label(value, 3), dash);
        EXPECT_EQ(plot::label_with_deviation(value, 0.1), dash);
        EXPECT_EQ(plot::millimetres(value), dash + " mm");
    }
}

TEST(NumberLabels, PlainOnesHaveNoZerosAtTheEnd) {
    EXPECT_EQ(plot::plain_label(30.0, 3), "30");
    EXPECT_EQ(plot::plain_label(0.25, 6), "0.25");
    EXPECT_EQ(plot::plain_label(1.0 / 3.0, 3), "0.333");
    EXPECT_EQ(plot::plain_label(1234567.0, 3), "1.23e+06");
    EXPECT_EQ(plot::plain_label(-4.5, 3), minus + "4.5");
    EXPECT_EQ(plot::plain_label(-0.0, 3), "0") << "a zero has no sign";
}

TEST(NumberLabels, ADeviationDecidesTheDecimals) {
    EXPECT_EQ(plot::label_with_deviation(12.341, 0.42), "12.34 ± 0.42");
    EXPECT_EQ(plot::label_with_deviation(12.341, 0.042), "12.341 ± 0.042");
    EXPECT_EQ(plot::label_with_deviation(12.341, 4.2), "12.3 ± 4.2");
    EXPECT_EQ(plot::label_with_deviation(1234.1, 42.0), "1234 ± 42");
    EXPECT_EQ(plot::label_with_deviation(1234.1, 420.0), "1234 ± 420") << "digits before the point stay";
    EXPECT_EQ(plot::label_with_deviation(-12.341, 0.42), minus + "12.34 ± 0.42");
    EXPECT_EQ(plot::label_with_deviation(-0.001, 0.5), "0.00 ± 0.50") << "no minus before zeros";
    EXPECT_EQ(plot::label_with_deviation(1.0, 1e-30), "1.000000000000 ± 0.000000000000");
}

TEST(NumberLabels, WithoutADeviationTheValueStandsAlone) {
    for (const double unknown : {0.0, -0.1, nan, infinite})
        EXPECT_EQ(plot::label_with_deviation(12.341, unknown), "12.34") << unknown;
}

TEST(NumberLabels, LengthsAreInMillimetres) {
    EXPECT_EQ(plot::millimetres(0.00123), "1.23 mm");
    EXPECT_EQ(plot::millimetres(0.1), "100 mm");
    EXPECT_EQ(plot::millimetres(-4.5e-5), minus + "0.0450 mm");
}

}  // namespace
}  // namespace myo::ui::number_labels
