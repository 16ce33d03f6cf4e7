#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "toml/toml_edit.hpp"
#include "toml/toml_lines.hpp"
#include "toml/toml_text.hpp"

namespace myo::toml {
namespace {

using Kind = TomlValue::Kind;

// Forms that the examples do not have.
const std::string all_forms =
    "\xEF\xBB\xBFtitle = 'R\u00fccken' # \u00fcber\n"
    "long = \"\"\"\nfirst # no comment\n\\\"\"\"second\"\"\"\n"
    "a.\"b.c\" . d = 1\na.e = { f = { g = [1, { h = 2 }], i.j = 3 }, k = true }\n"
    "list = [ # of pairs\n  [1.0, 2.0], # first ]\n  [\n    3.0,\n  4.0 ]\n  , # second\n]\n\n"
    "# deep\n  [ x . \"\u00e4\" . 'z z' ] # header\n  \"key # 1\" = \"]\" # end\n  2 = -inf\n\n"
    "[x]\ny = 1_000\n# about the next\n[[t]]\n[t.u]\nv = +1.5\n[[t.w]]\nv = 2\n[[t.w.q]]\nv = 3\n[[t]]\n[[t.w]]\nv = 4";

struct Document {
    std::string name;
    std::string text;
};

std::string with_crlf(const std::string& text) { return with_line_ends(text, "\r\n"); }

// The bundled examples, one text with all forms, and both kinds of line ends.
std::vector<Document> documents() {
    std::vector<Document> found{{"all forms", all_forms}, {"all forms, CRLF", with_crlf(all_forms)}};
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets/examples")) {
        const auto file = entry.path() / "experiment.toml";
        if (!std::filesystem::exists(file)) continue;
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        found.push_back({file.string(), text.str()});
    }
    EXPECT_GE(found.size(), 9u);
    return found;
}

std::vector<Document> examples() {
    std::vector<Document> found = documents();
    found.erase(found.begin(), found.begin() + 2);
    return found;
}

void collect_places(const TomlValue& value, TomlPath& path, std::vector<TomlPath>& places) {
    for (std::size_t i = 0; i < value.items.size(); ++i) {
        path.push_back(value.kind == Kind::table ? TomlStep(value.keys[i]) : TomlStep(i));
        places.push_back(path);
        collect_places(value.items[i], path, places);
        path.pop_back();
    }
}

// All values of a document, with those that hold others.
std::vector<TomlPath> places_of(const TomlValue& document) {
    std::vector<TomlPath> places;
    TomlPath path;
    collect_places(document, path, places);
    return places;
}

bool is_leaf(const TomlValue& value) { return value.kind != Kind::array && value.kind != Kind::table; }

// Another value of the same kind.
TomlValue other_value(TomlValue value) {
    value.number = value.number == 0.0 ? 0.125 : std::isfinite(value.number) ? 3.0 * value.number : 1.0;
    value.text += " R\u00fccken \"#]";
    value.truth = !value.truth;
    return value;
}

std::string value_text(const TomlValue& value) {
    if (value.kind == Kind::text) return toml_text(value.text);
    if (value.kind == Kind::number) return toml_number(value.number);
    if (value.kind == Kind::boolean) return value.truth ? "true" : "false";
    if (value.kind == Kind::array) return toml_list(value.items, value_text);
    std::string entries;
    for (std::size_t i = 0; i < value.items.size(); ++i)
        entries += (i == 0 ? "" : ", ") + toml_key(value.keys[i]) + " = " + value_text(value.items[i]);
    return "{" + entries + "}";
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// Text behind each "#" that no test document has within a value, except the first two lines of the long string.
std::vector<std::string> comments_of(const std::string& text) {
    std::vector<std::string> comments;
    for (const std::string& line : lines_of(text))
        if (const std::size_t at = line.find('#'); at != std::string::npos) comments.push_back(line.substr(at));
    return comments;
}

TomlValue parsed(const std::string& text) {
    const Result<TomlValue> values = parse_toml(text, "");
    EXPECT_TRUE(values) << values.error().text() << "\n" << text;
    return values ? *values : TomlValue{};
}

TEST(TomlEditOfExamples, SetsEveryLeafAndChangesItsLineOnly) {
    for (const Document& document : documents()) {
        const TomlValue before = parsed(document.text);
        std::size_t leaves = 0;
        for (const TomlPath& path : places_of(before)) {
            const TomlValue& leaf = *find_at(before, path);
            if (!is_leaf(leaf) || leaf.text.find('\n') != std::string::npos) continue;
            SCOPED_TRACE(document.name + " " + path_text(path));
            ++leaves;
            const TomlValue other = other_value(leaf);
            const Result<std::string> edited = with_value(document.text, path, value_text(other));
            ASSERT_TRUE(edited) << edited.error().text();
            TomlValue expected = before;
            *find_at(expected, path) = other;
            EXPECT_TRUE(same_values(parsed(*edited), expected));
            EXPECT_FALSE(same_values(parsed(*edited), before));

            std::vector<std::string> old_lines = lines_of(document.text), new_lines = lines_of(*edited);
            ASSERT_EQ(old_lines.size(), new_lines.size());
            const std::size_t line = std::stoul(leaf.where.substr(leaf.where.find(' '))) - 1;
            EXPECT_NE(old_lines[line], new_lines[line]);
            old_lines[line] = new_lines[line];
            EXPECT_EQ(old_lines, new_lines);

            const Result<std::string> undone = with_value(*edited, path, value_text(leaf));
            ASSERT_TRUE(undone);
            EXPECT_TRUE(same_values(parsed(*undone), before));
        }
        EXPECT_GT(leaves, 10u);
    }
}

// Removal of a value takes nothing else away; what a value can express is then added again.
TEST(TomlEditOfExamples, RemovesEveryValueAndAddsItAgain) {
    for (const Document& document : documents()) {
        const TomlValue before = parsed(document.text);
        for (const TomlPath& path : places_of(before)) {
            SCOPED_TRACE(document.name + " " + path_text(path));
            const Result<std::string> removed = without(document.text, path);
            ASSERT_TRUE(removed) << removed.error().text();
            EXPECT_LT(removed->size(), document.text.size());
            EXPECT_EQ(find_at(parsed(*removed), path) == nullptr || std::holds_alternative<std::size_t>(path.back()),
                      true);
            if (!std::holds_alternative<std::string>(path.back())) continue;
            const Result<std::string> added = with_value(*removed, path, value_text(*find_at(before, path)));
            ASSERT_TRUE(added) << added.error().text() << "\n" << *removed;
            EXPECT_TRUE(same_values(parsed(*added), before)) << *added;
        }
    }
}

TEST(TomlEditOfExamples, RenamesEveryKeyAndBack) {
    for (const Document& document : documents()) {
        for (const TomlPath& path : places_of(parsed(document.text))) {
            const std::string* key = std::get_if<std::string>(&path.back());
            if (key == nullptr) continue;
            SCOPED_TRACE(document.name + " " + path_text(path));
            const Result<std::string> renamed = with_renamed_key(document.text, path, "some_other_key");
            ASSERT_TRUE(renamed) << renamed.error().text();
            TomlPath new_path = path;
            new_path.back() = "some_other_key";
            const Result<std::string> back = with_renamed_key(*renamed, new_path, *key);
            ASSERT_TRUE(back) << back.error().text();
            EXPECT_TRUE(same_values(parsed(*back), parsed(document.text)));
            EXPECT_EQ(lines_of(*back).size(), lines_of(document.text).size());
        }
    }
}

TEST(TomlEditOfExamples, AppendsATrialAndALoadAndKeepsTheRest) {
    for (const Document& document : examples()) {
        SCOPED_TRACE(document.name);
        const std::size_t trials = parsed(document.text).find("trial")->items.size();
        const Result<std::string> trial = with_appended_table(document.text, {"trial"}, "name = \"new\"\n");
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(*trial, document.text + "\n[[trial]]\nname = \"new\"\n");
        for (std::size_t i = 0; i <= trials; ++i) {
            const Result<std::string> load = with_appended_table(*trial, {"trial", i, "load"}, "kind = \"mass\"\n");
            ASSERT_TRUE(load) << load.error().text();
            EXPECT_EQ(comments_of(*load), comments_of(document.text));
            EXPECT_EQ(parsed(*load).find("trial")->items[i].find("load")->items.back().find("kind")->text, "mass");
            const TomlPath last{"trial", i, "load",
                                parsed(*load).find("trial")->items[i].find("load")->items.size() - 1};
            const Result<std::string> back = without(*load, last);
            ASSERT_TRUE(back) << back.error().text();
            EXPECT_EQ(*back, *trial);
        }
    }
}

TEST(TomlEditOfExamples, DuplicatesEveryElementAndRemovesItAgain) {
    for (const Document& document : examples()) {
        for (const TomlPath& path : places_of(parsed(document.text))) {
            if (!std::holds_alternative<std::size_t>(path.back())) continue;
            SCOPED_TRACE(document.name + " " + path_text(path));
            const Result<std::string> twice = with_duplicated_table(document.text, path);
            if (!twice) {
                EXPECT_EQ(twice.error().what, "is no element of an array of tables");
                continue;
            }
            TomlPath copy = path;
            ++std::get<std::size_t>(copy.back());
            const TomlValue after = parsed(*twice);
            EXPECT_TRUE(same_values(*find_at(after, path), *find_at(after, copy)));
            const Result<std::string> back = without(*twice, copy);
            ASSERT_TRUE(back) << back.error().text();
            EXPECT_EQ(*back, document.text);
        }
    }
}

}  // namespace
}  // namespace myo::toml
