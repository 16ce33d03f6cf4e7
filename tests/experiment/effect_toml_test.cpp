#include "experiment/effect_toml.hpp"

#include <gtest/gtest.h>

namespace myo::experiment {
namespace {

TEST(EffectToml, HoldsEveryKindOfValue) {
    EXPECT_EQ(effect_toml(0.1), "0.1");
    EXPECT_EQ(effect_toml(3.0), "3.0") << "3 would be an integer";
    EXPECT_EQ(effect_toml(std::string("tip \"left\"\n")), "\"tip \\\"left\\\"\\u000a\"");
    EXPECT_EQ(effect_toml(std::vector<std::string>{"a", "b"}), "[\"a\", \"b\"]");
    EXPECT_EQ(effect_toml(Eigen::VectorXd(Eigen::Vector3d(0.0, 1e-17, -2.5))), "[0.0, 1e-17, -2.5]");
}

TEST(EffectToml, FormatsNumbersAsAsked) {
    const auto rounded = [](double value) { return std::to_string(static_cast<int>(value)); };
    EXPECT_EQ(effect_toml(2.7, rounded), "2");
    EXPECT_EQ(effect_toml(Eigen::VectorXd(Eigen::Vector2d(2.7, -1.2)), rounded), "[2, -1]");
    EXPECT_EQ(effect_toml(std::string("2.7"), rounded), "\"2.7\"");
}

}  // namespace
}  // namespace myo::experiment
