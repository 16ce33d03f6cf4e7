#include "base/result.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace myo {
namespace {

Result<double> root(double value) {
    if (value < 0.0) return Error{"is negative", "value"};
    return value * value;
}

TEST(Result, HoldsAValueOrAReason) {
    const Result<double> good = root(3.0), bad = root(-1.0);
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 9.0);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().text(), "value: is negative");
    EXPECT_EQ((Error{"no place", ""}.text()), "no place");
}

TEST(Result, MovesItsValueOut) {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
    const std::unique_ptr<int> value = std::move(result).value();
    EXPECT_EQ(*value, 7);
    Result<std::vector<int>> list(std::vector<int>{1, 2, 3});
    list->push_back(4);
    const int* data = list->data();
    const std::vector<int> moved = *std::move(list);
    EXPECT_EQ(moved.data(), data);
    EXPECT_EQ(moved.size(), 4u);
}

TEST(ResultOfNothing, IsSuccessUnlessToldOtherwise) {
    EXPECT_TRUE(Result<void>());
    const Result<void> bad = Error{"full", "disk"};
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.error().text(), "disk: full");
}

}  // namespace
}  // namespace myo
