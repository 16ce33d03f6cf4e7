#include <gtest/gtest.h>

#include "toml/toml_key.hpp"
#include "toml/toml_text.hpp"

namespace myo::test {
namespace {

const char* const document_text = R"(a = 1
[[trial]]
name = "pull"
[[trial.load]]
force_N = [0, 0, 1]
[[trial]]
name = "a.b"
[[effect]]
id = "drag"
)";

std::string path_of(const std::string& key) {
    const Result<toml::TomlValue> document = toml::parse_toml(document_text, "");
    const Result<toml::TomlPath> path = toml::path_of_key(*document, key);
    return path ? toml::path_text(*path) : path.error().text();
}

TEST(TomlKey, NamesAndNumbersLeadToTheSamePlace) {
    for (const char* key : {"trial[0].load[0].force_N", "trial.pull.load[0].force_N"})
        EXPECT_EQ(path_of(key), "trial[0].load[0].force_N");
    EXPECT_EQ(path_of("trial.pull.load[0].force_N[2]"), "trial[0].load[0].force_N[2]");
    EXPECT_EQ(path_of("trial.\"a.b\".name"), "trial[1].name");
    EXPECT_EQ(path_of("effect.drag.id"), "effect[0].id");
}

TEST(TomlKey, WhatIsMissingIsNew) {
    EXPECT_EQ(path_of("material.damping_s"), "material.damping_s");
    EXPECT_EQ(path_of("trial[2].load[0].mass_kg"), "trial[2].load[0].mass_kg");
}

TEST(TomlKey, ErrorsSayWhy) {
    EXPECT_EQ(path_of("trial.pul.role"), "no trial is called \"pul\"; the closest name is \"pull\"");
    EXPECT_EQ(path_of("trial[3].role"), "trial has 2 elements");
    EXPECT_EQ(path_of("a.b"), "a is a number, so it has no b");
    EXPECT_EQ(path_of("a[0]"), "a has no elements");
    EXPECT_EQ(path_of("new[1]"), "new has 0 elements");
    for (const char* key : {"", "a..b", "a[", "a[x]", "a[0]x", "\"a"})
        EXPECT_EQ(path_of(key), "is not a key such as material.density_kg_m3 or trial[0].start_s") << key;
}

TEST(TomlValueText, IsReadBackAsTheSameValue) {
    for (const std::string value : {"1.0", "-3e-05", "inf", "\"a \\\"b\\\"\"", "true", "[1, [2.5, \"x\"]]",
                                    "{a = 1, \"b c\" = [true], d = {}}"}) {
        const Result<toml::TomlValue> read = toml::parse_toml("v = " + value, "");
        ASSERT_TRUE(read) << value;
        const Result<toml::TomlValue> again = toml::parse_toml("v = " + toml::toml_value_text(*read->find("v")), "");
        ASSERT_TRUE(again) << value;
        EXPECT_TRUE(toml::same_values(*read, *again)) << value;
    }
}

}  // namespace
}  // namespace myo::test
