#include "toml/toml_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/folder.hpp"

namespace myo::toml {
namespace {

using testing::ElementsAre;

/// A document with one value of each kind; line numbers are part of the tests.
constexpr const char* document_text = R"(name = "beam"
count = 3
share = 0.25
zero = 0.0
endless = inf
on = true
words = ["a", "b"]
direction = [0.0, 0.6, 0.8]
turn = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
region = [[0, 0, 0], [1, 2, 3]]
cloud = [[1, 2, 3], [4, 5, 6]]
file = "there.txt"
mixed = [1, "two"]
blank = " padded"
upside = [[0, 5, 0], [1, 2, 3]]
gap = [1.0, nan, 2.0]
[part]
size = 2.0
[[item]]
id = "first"
[[item]]
id = "second"
)";

class Reader : public testing::Test {
protected:
    Reader() : folder_("toml_reader") {
        folder_.write("e.toml", document_text);
        folder_.write("there.txt", "");
        document_ = *read_toml(folder_.path() / "e.toml");
    }

    TomlReader reader() const {
        std::vector<std::string> known = document_.keys;
        known.push_back("absent");
        return {document_, "", known};
    }

    /// Message of what fails, and its line: "12: key: reason". Empty if it does not fail.
    std::string failure(const std::function<void(const TomlReader&)>& read) const {
        try {
            read(reader());
        } catch (const TomlFailure& failed) {
            const std::string file = folder_.str("e.toml") + ":";
            EXPECT_EQ(failed.error.where.substr(0, file.size()), file);
            return failed.error.where.substr(file.size()) + ": " + failed.error.what;
        }
        return {};
    }

    test::Folder folder_;
    TomlValue document_;
};

TEST_F(Reader, ReturnsValues) {
    const TomlReader read = reader();
    EXPECT_EQ(read.text("name"), "beam");
    EXPECT_EQ(read.name("name"), "beam");
    EXPECT_EQ(read.number("count"), 3.0);
    EXPECT_EQ(read.number("share", between(0.0, 1.0)), 0.25);
    EXPECT_TRUE(read.boolean_or("on", false));
    EXPECT_THAT(read.texts("words"), ElementsAre("a", "b"));
    EXPECT_EQ(read.vector3("direction"), Eigen::Vector3d(0.0, 0.6, 0.8));
    const Eigen::Matrix3d R = read.matrix3("turn");
    EXPECT_EQ(R(0, 1), -1.0);
    EXPECT_EQ(R(1, 0), 1.0);
    EXPECT_EQ(read.box("region").highest, Eigen::Vector3d(1.0, 2.0, 3.0));
    const Eigen::Matrix3Xd cloud = read.points("cloud");
    ASSERT_EQ(cloud.cols(), 2);
    EXPECT_EQ(cloud(1, 0), 2.0);
    EXPECT_EQ(cloud(0, 1), 4.0);
    EXPECT_EQ(read.file("file", folder_.path()), folder_.path() / "there.txt");
    EXPECT_EQ(read.choice<int>("name", {{"arm", 1}, {"beam", 2}}), 2);
    EXPECT_TRUE(read.is_text("name") && !read.is_text("count") && read.is_array("words") && !read.is_array("on"));
}

TEST_F(Reader, FallsBackOnlyWhereAKeyIsAbsent) {
    const TomlReader read = reader();
    EXPECT_EQ(read.number_or("absent", 7.0), 7.0);
    EXPECT_EQ(read.number_or("share", 7.0), 0.25);
    EXPECT_FALSE(read.optional_number("absent").has_value());
    EXPECT_EQ(read.optional_number("share"), 0.25);
    EXPECT_TRUE(read.boolean_or("absent", true));
    EXPECT_EQ(read.text_or("absent", "else"), "else");
    EXPECT_EQ(read.text_or("name", "else"), "beam");
    EXPECT_TRUE(read.tables("absent", {}).empty());
    EXPECT_FALSE(read.has("absent"));
    EXPECT_FALSE(read.has_entry("unheard of"));
}

TEST_F(Reader, SaysWhichKeyIsMissing) {
    // The location is that of the table.
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("absent"); }), "1: absent: required key is missing");
    EXPECT_EQ(failure([](const TomlReader& r) { r.text("absent"); }), "1: absent: required key is missing");
    EXPECT_EQ(failure([](const TomlReader& r) {
                  r.table("part", {"size", "mass"}).number("mass");
              }),
              "17: part.mass: required key is missing");
}

TEST_F(Reader, SaysWhatKindIsWanted) {
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("name"); }), "1: name: must be a number, not a string");
    EXPECT_EQ(failure([](const TomlReader& r) { r.text("count"); }), "2: count: must be a string, not a number");
    EXPECT_EQ(failure([](const TomlReader& r) { r.boolean_or("count", true); }),
              "2: count: must be true or false, not a number");
    EXPECT_EQ(failure([](const TomlReader& r) { r.texts("mixed"); }),
              "13: mixed: must hold strings only, not a number");
    EXPECT_EQ(failure([](const TomlReader& r) { r.vector("mixed", 2); }),
              "13: mixed: must hold numbers only, not a string");
    EXPECT_EQ(failure([](const TomlReader& r) { r.vector3("count"); }),
              "2: count: must be an array of 3 numbers, not a number");
    EXPECT_EQ(failure([](const TomlReader& r) { r.vector3("words"); }), "7: words: must have 3 numbers, not 2");
    EXPECT_EQ(failure([](const TomlReader& r) { r.vector3("gap"); }),
              "16: gap: must hold finite numbers only, not nan");
    EXPECT_EQ(failure([](const TomlReader& r) { r.matrix3("region"); }),
              "10: region: must have 3 rows of 3 numbers, not 2 rows");
    EXPECT_EQ(failure([](const TomlReader& r) { r.table("share", {}); }), "3: share: must be a table, not a number");
}

TEST_F(Reader, SaysWhatRangeIsWanted) {
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("zero", positive()); }),
              "4: zero: must be positive and finite, not 0");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("zero", not_negative()); }), "");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("count", between(0.0, 2.5)); }),
              "2: count: must be between 0 and 2.5, not 3");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("count", strictly_between(0.0, 3.0)); }),
              "2: count: must be above 0 and below 3, not 3");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("endless"); }), "5: endless: must be finite, not inf");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("endless", positive()); }),
              "5: endless: must be positive and finite, not inf");
    EXPECT_EQ(failure([](const TomlReader& r) { r.number("endless", any_or_infinite()); }), "");
}

TEST(NumberRanges, ContainTheirBoundsUnlessOpen) {
    EXPECT_TRUE(between(-1.0, 1.0).contains(-1.0) && between(-1.0, 1.0).contains(1.0));
    EXPECT_FALSE(between(-1.0, 1.0).contains(std::nextafter(1.0, 2.0)));
    EXPECT_FALSE(strictly_between(-1.0, 1.0).contains(-1.0) || strictly_between(-1.0, 1.0).contains(1.0));
    EXPECT_TRUE(strictly_between(-1.0, 1.0).contains(std::nextafter(1.0, 0.0)));
    EXPECT_FALSE(not_negative().contains(-1e-300));
    EXPECT_TRUE(not_negative().contains(0.0));
    EXPECT_FALSE(not_negative().contains(std::numeric_limits<double>::infinity()));
    EXPECT_TRUE(positive().contains(1e-300));
    for (const NumberRange& range : {any_number(), any_or_infinite(), positive(), not_negative(), between(0.0, 1.0)})
        EXPECT_FALSE(range.contains(std::nan("")));
}

TEST_F(Reader, RefusesBoxesThatAreUpsideDownOrNoBoxes) {
    EXPECT_EQ(failure([](const TomlReader& r) { r.box("upside"); }),
              "15: upside: lowest corner is above the highest (y 5 > 2)");
    EXPECT_EQ(failure([](const TomlReader& r) { r.box("turn"); }),
              "9: turn: must be two corners [[x, y, z], [x, y, z]], not 3 elements");
}

TEST_F(Reader, RefusesNamesThatCannotBeTold) {
    EXPECT_EQ(failure([](const TomlReader& r) { r.name("blank"); }), "14: blank: must not begin or end with a blank");
    document_.find("name")->text = " ";
    EXPECT_EQ(failure([](const TomlReader& r) { r.name("name"); }), "1: name: must not be empty");
    document_.find("name")->text = "two\tparts";
    EXPECT_EQ(failure([](const TomlReader& r) { r.name("name"); }), "1: name: must not contain tabs or line breaks");
    EXPECT_EQ(failure([](const TomlReader& r) { r.text("name"); }), "");
}

TEST_F(Reader, SaysWhichFileIsMissing) {
    const auto read = [this](const TomlReader& r) { r.file("file", folder_.path() / "elsewhere"); };
    EXPECT_EQ(failure(read), "12: file: file not found: " + (folder_.path() / "elsewhere" / "there.txt").string());
    document_.find("file")->text = ".";
    EXPECT_EQ(failure([this](const TomlReader& r) { r.file("file", folder_.path()); }),
              "12: file: is not a file: " + (folder_.path() / "").string());
    document_.find("file")->text = "";
    EXPECT_EQ(failure([this](const TomlReader& r) { r.file("file", folder_.path()); }),
              "12: file: must be a file name");
    // An absolute name does not depend on the folder.
    document_.find("file")->text = folder_.str("there.txt");
    EXPECT_EQ(reader().file("file", "/elsewhere"), folder_.path() / "there.txt");
}

TEST_F(Reader, SuggestsTheClosestWord) {
    EXPECT_EQ(failure([](const TomlReader& r) {
                  r.choice<int>("name", {{"beam_2d", 1}, {"tail", 2}});
              }),
              "1: name: unknown value \"beam\"; the closest known one is \"beam_2d\"");
    EXPECT_EQ(suggest("gravity", {"density_kg_m3", "gravity_m_s2"}), "the closest known one is \"gravity_m_s2\"");
    EXPECT_EQ(suggest("tirals", {"trial", "muscle"}), "the closest known one is \"trial\"");
    EXPECT_EQ(suggest("qqq", {"trial", "muscle"}), "known are trial, muscle");
    EXPECT_EQ(suggest("q", {}), "none is known here");
}

TEST_F(Reader, RefusesUnknownAndMeaninglessKeys) {
    EXPECT_EQ(failure([](const TomlReader& r) { r.table("part", {"sizes"}); }),
              "18: part.size: unknown key; the closest known one is \"sizes\"");
    EXPECT_EQ(failure([](const TomlReader& r) { r.reject("share", "has no meaning beside count"); }),
              "3: share: has no meaning beside count");
    EXPECT_EQ(failure([](const TomlReader& r) { r.reject("absent", "never"); }), "");
}

TEST_F(Reader, NumbersTheTablesOfAnArray) {
    const std::vector<TomlReader> items = reader().tables("item", {"id"});
    ASSERT_EQ(items.size(), 2u);
    EXPECT_EQ(items[1].text("id"), "second");
    EXPECT_EQ(items[1].path(), "item[1]");
    EXPECT_EQ(items[1].path_of("id"), "item[1].id");
    EXPECT_EQ(items[0].where(), folder_.str("e.toml") + ":19");
    EXPECT_EQ(failure([](const TomlReader& r) { r.tables("item", {"name"}); }),
              "20: item[0].id: unknown key; known are name");
    EXPECT_EQ(failure([](const TomlReader& r) { r.tables("part", {"size"}); }),
              "17: part: must be an array of tables, not a table; write [[part]]");
    EXPECT_EQ(failure([](const TomlReader& r) { r.tables("words", {}); }),
              "7: words: must hold tables only, not a string; write [[words]]");
    EXPECT_THAT(reader().table_of_names("part").keys(), ElementsAre("size"));
}

}  // namespace
}  // namespace myo::toml
