#include "plot/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace myo::ui {
namespace {

TEST(NumberText, HasTheWantedDigitsAndATrueMinus) {
    EXPECT_EQ(plot::value_label(-0.0049236, 3),
              "\xe2\x88\x92"
              "0.00492");
    EXPECT_EQ(plot::value_label(263824.0, 3), "263824");
    EXPECT_EQ(plot::value_label(-0.0, 3), "0.00");
    EXPECT_EQ(plot::value_label(std::nan(""), 3), "\xe2\x80\x93");
}

}  // namespace
}  // namespace myo::ui
