#include "toml/toml_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/folder.hpp"
#include "toml/toml_reader.hpp"

namespace myo::toml {
namespace {

using Kind = TomlValue::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The document with this content.
Result<TomlValue> read_text(const test::Folder& folder, const std::string& text) {
    folder.write("e.toml", text);
    return read_toml(folder.path() / "e.toml");
}

TEST(TomlDocument, KeepsKindsAndValues) {
    const test::Folder folder("toml_kinds");
    const Result<TomlValue> read = read_text(folder,
                                             "t = \"words\"\ni = 3\nx = -2.5e-3\nb = true\nd = 2024-05-01\n"
                                             "a = [1, [2.0, \"three\"], { k = 4 }]\nn = nan\nm = -inf\n");
    ASSERT_TRUE(read) << read.error().text();
    const TomlValue& document = *read;
    EXPECT_EQ(document.kind, Kind::table);
    EXPECT_EQ(document.find("t")->text, "words");
    EXPECT_EQ(document.find("i")->kind, Kind::number);
    EXPECT_EQ(document.find("i")->number, 3.0);
    EXPECT_EQ(document.find("x")->number, -2.5e-3);
    EXPECT_EQ(document.find("b")->kind, Kind::boolean);
    EXPECT_TRUE(document.find("b")->truth);
    EXPECT_EQ(document.find("d")->kind, Kind::date);
    EXPECT_TRUE(std::isnan(document.find("n")->number));
    EXPECT_EQ(document.find("m")->number, -std::numeric_limits<double>::infinity());
    const TomlValue& array = *document.find("a");
    ASSERT_EQ(array.items.size(), 3u);
    EXPECT_EQ(array.items[1].kind, Kind::array);
    EXPECT_EQ(array.items[1].items[1].text, "three");
    EXPECT_EQ(array.items[2].find("k")->number, 4.0);
    EXPECT_EQ(document.find("absent"), nullptr);
}

/// The order is that of the file, which messages and rewritten files follow; it is not the alphabet's.
TEST(TomlDocument, KeepsTheOrderOfTheFile) {
    const test::Folder folder("toml_order");
    const Result<TomlValue> read = read_text(folder, "zeta = 1\nalpha = 2\n[muscle]\nb = 1\na = 2\n[clamp]\nc = 3\n");
    ASSERT_TRUE(read);
    EXPECT_THAT(read->keys, ElementsAre("zeta", "alpha", "muscle", "clamp"));
    EXPECT_THAT(read->find("muscle")->keys, ElementsAre("b", "a"));
}

TEST(TomlDocument, KnowsTheLineOfEveryValue) {
    const test::Folder folder("toml_lines");
    const std::string text =
        "# a comment\nname = \"x\"\n\n[trial]\nload = [\n  1.0,\n  2.0,\n]\n[[marker]]\nid = 1\n"
        "[[marker]]\nid = 2\n";
    const Result<TomlValue> read = read_text(folder, text);
    ASSERT_TRUE(read);
    const auto at = locations(*read);
    const std::string file = folder.str("e.toml");
    EXPECT_EQ(at.at("name"), file + ":2");
    EXPECT_EQ(at.at("trial"), file + ":4");
    EXPECT_EQ(at.at("trial.load"), file + ":5");
    EXPECT_EQ(at.at("trial.load[1]"), file + ":7");
    EXPECT_EQ(at.at("marker[0].id"), file + ":10");
    EXPECT_EQ(at.at("marker[1].id"), file + ":12");
    EXPECT_EQ(at.size(), 10u);
}

TEST(TomlDocument, SaysWhereItIsNoToml) {
    const test::Folder folder("toml_syntax");
    Result<TomlValue> read = read_text(folder, "a = 1\nb = = 2\n");
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, StartsWith("this is not valid TOML: "));
    EXPECT_EQ(read.error().where, folder.str("e.toml") + ":2");
    read = read_text(folder, "a = 1\n\na = 2\n");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where, folder.str("e.toml") + ":3");
    EXPECT_FALSE(read_text(folder, "a = \"no end\n"));
    EXPECT_FALSE(read_text(folder, "[table\n"));
    EXPECT_FALSE(read_toml(folder.path() / "missing.toml"));
    EXPECT_FALSE(read_toml(folder.path()));
}

TEST(TomlDocument, OfADeviceOrOfGreatSizeIsRefused) {
    const test::Folder folder("toml_size");
    const Result<TomlValue> device = read_toml("/dev/zero");
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().what, "is not a regular file");
    folder.write("large.toml", "");
    std::filesystem::resize_file(folder.path() / "large.toml", (16u << 20) + 1);
    const Result<TomlValue> large = read_toml(folder.path() / "large.toml");
    ASSERT_FALSE(large);
    EXPECT_THAT(large.error().what, HasSubstr("larger than 16 MB"));
}

TEST(TomlDocument, MayBeEmpty) {
    const test::Folder folder("toml_empty");
    const Result<TomlValue> read = read_text(folder, "");
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->keys.empty());
    EXPECT_EQ(read->where, folder.str("e.toml") + ":1");
}

TEST(TomlDocument, MayBeATextWithAName) {
    const Result<TomlValue> read = parse_toml("a = 1\n[b]\nc = 2\n", "form");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->where, "form:1");
    EXPECT_EQ(read->find("b")->find("c")->where, "form:3");
    EXPECT_EQ(parse_toml("a = 1\n\na = 2\n", "form").error().where, "form:3");
    EXPECT_EQ(parse_toml("a = 1\n\na = 2\n", "").error().where, "line 3");
}

TEST(TomlDocument, IsComparedByItsValues) {
    const auto same = [](const std::string& a, const std::string& b) {
        return same_values(*parse_toml(a, "a"), *parse_toml(b, "b"));
    };
    EXPECT_TRUE(same("a = 1\nb = [1.0, nan, { c = true }]\n", "# c\nb = [1, nan, { c = true }]\na = 1.0\n"));
    EXPECT_FALSE(same("a = 1\n", "a = 2\n"));
    EXPECT_FALSE(same("a = 1\n", "b = 1\n"));
    EXPECT_FALSE(same("a = 1\n", "a = 1\nb = 1\n"));
    EXPECT_FALSE(same("a = 1\n", "a = \"1\"\n"));
    EXPECT_FALSE(same("a = \"x\"\n", "a = \"y\"\n"));
    EXPECT_FALSE(same("a = true\n", "a = false\n"));
    EXPECT_FALSE(same("a = [1, 2]\n", "a = [2, 1]\n"));
    EXPECT_FALSE(same("a = nan\n", "a = 1\n"));
}

TEST(TomlValueText, IsOneValue) {
    EXPECT_EQ(parse_toml_value("3e5", "--set")->number, 3e5);
    EXPECT_EQ(parse_toml_value("true", "--set")->kind, Kind::boolean);
    EXPECT_EQ(parse_toml_value("[0, 0, -1]", "--set")->items[2].number, -1.0);
    EXPECT_EQ(parse_toml_value("[0, 0, -1]", "--set")->items[2].where, "--set");
    EXPECT_EQ(parse_toml_value("\"3\"", "--set")->kind, Kind::text);
}

TEST(TomlValueText, MayBeABareWord) {
    for (const char* word : {"neo_hookean", "data/trace.csv", "../x-1.stl", "1e5x", "März.csv"}) {
        const Result<TomlValue> parsed = parse_toml_value(word, "--set");
        ASSERT_TRUE(parsed) << word;
        EXPECT_EQ(parsed->kind, Kind::text);
        EXPECT_EQ(parsed->text, word);
        EXPECT_EQ(parsed->where, "--set");
    }
}

TEST(TomlValueText, IsNothingElse) {
    for (const char* text : {"", "[1, 2", "two words", "1\nb = 2", "= 3", "1.2.3", "{"}) {
        const Result<TomlValue> parsed = parse_toml_value(text, "--set");
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().what, "\"" + std::string(text) + "\" is not one value in TOML syntax");
        EXPECT_EQ(parsed.error().where, "--set");
    }
}

TEST(TomlKinds, HaveNames) {
    EXPECT_EQ(kind_name(Kind::text), "a string");
    EXPECT_EQ(kind_name(Kind::number), "a number");
    EXPECT_EQ(kind_name(Kind::boolean), "true or false");
    EXPECT_EQ(kind_name(Kind::date), "a date or time");
    EXPECT_EQ(kind_name(Kind::array), "an array");
    EXPECT_EQ(kind_name(Kind::table), "a table");
}

}  // namespace
}  // namespace myo::toml
