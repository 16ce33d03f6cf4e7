#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "toml/toml_edit.hpp"

namespace myo::toml {
namespace {

using testing::StartsWith;

/// The edited text, or the error's text.
std::string table_text(const Result<std::string>& edited) { return edited ? *edited : edited.error().text(); }

std::string cut(const std::string& document, const TomlPath& path) { return table_text(without(document, path)); }

std::string appended(const std::string& document, const TomlPath& array, const std::string& body) {
    return table_text(with_appended_table(document, array, body));
}

std::string duplicated(const std::string& document, const TomlPath& element) {
    return table_text(with_duplicated_table(document, element));
}

const std::string head = "name = \"beam\" # title\n# about\nunit = 1\n\n";
const std::string clamp = "# Clamp\n# by hand\n[clamp]\nbox = [1]\n# spare = 2\n\n";
const std::string markers = "[markers]\nnoise_m = 1.0\n[markers.rest_m]\ntip = 1\n\n";
const std::string first = "# the first\n[[trial]]\nname = \"a\"\n\n";
const std::string
    second = "[[trial]]\nname = \"b\" # second\n[[trial.load]]\nkind = \"x\"\n[[trial.load]]\nkind = \"y\"\n\n";
const std::string third = "[[trial]]\nname = \"c\"\n";
const std::string beam = head + clamp + markers + first + second + third;

TEST(TomlRemove, TakesAKeyWithItsLine) {
    EXPECT_EQ(cut(beam, {"name"}), "# about\nunit = 1\n\n" + clamp + markers + first + second + third);
    EXPECT_EQ(cut("a = [\n 1,\n] # list\nb = 2\n", {"a"}), "b = 2\n");
    EXPECT_EQ(cut("a = 1\nb = 2", {"b"}), "a = 1\n");
    EXPECT_EQ(cut("a = 1\nb = 2\n# spare\n", {"b"}), "a = 1\n# spare\n");
    EXPECT_EQ(cut("[t]\na.b = 1\nc = 2\na.d = 3\n", {"t", "a"}), "[t]\nc = 2\n");
    EXPECT_EQ(cut("a.b = 1\n", {"a", "b"}), "");
}

TEST(TomlRemove, TakesATableWithItsSubtablesAndComments) {
    EXPECT_EQ(cut(beam, {"clamp"}), head + markers + first + second + third);
    EXPECT_EQ(cut(beam, {"markers"}), head + clamp + first + second + third);
    EXPECT_EQ(cut(beam, {"markers", "rest_m"}), head + clamp + "[markers]\nnoise_m = 1.0\n\n" + first + second + third);
    EXPECT_EQ(cut("[a]\nx = 1\n\n# free\n\n[b]\n", {"a"}), "# free\n\n[b]\n");
    EXPECT_EQ(cut("[a]\nx = 1\n# about b\n[b]\n", {"a"}), "# about b\n[b]\n");
    EXPECT_EQ(cut("[a]\nx = 1\n# spare\n", {"a"}), "");
    EXPECT_EQ(cut("[a.b]\nx = 1\n[c]\n[a.d]\ny = 1\n", {"a"}), "[c]\n");
    EXPECT_EQ(cut("[a.b]\nx = 1\n", {"a", "b"}), "");
    EXPECT_EQ(cut("x = 1\r\n\r\n[a]\r\ny = 1\r\n\r\n[b]\r\n", {"a"}), "x = 1\r\n\r\n[b]\r\n");
}

TEST(TomlRemove, TakesAnElementWithItsSubtables) {
    EXPECT_EQ(cut(beam, {"trial", 0u}), head + clamp + markers + second + third);
    EXPECT_EQ(cut(beam, {"trial", 1u}), head + clamp + markers + first + third);
    EXPECT_EQ(cut(beam, {"trial", 2u}),
              (head + clamp + markers + first + second).substr(0, beam.size() - third.size() - 1));
    EXPECT_EQ(
        cut(beam, {"trial", 1u, "load", 0u}),
        head + clamp + markers + first + "[[trial]]\nname = \"b\" # second\n[[trial.load]]\nkind = \"y\"\n\n" + third);
    EXPECT_EQ(cut(beam, {"trial", 1u, "load"}),
              head + clamp + markers + first + "[[trial]]\nname = \"b\" # second\n\n" + third);
    EXPECT_EQ(cut("a = 1\n\n[[t]]\nx = 1\n", {"t", 0u}), "a = 1\n");
}

TEST(TomlRemove, TakesEntriesOfArraysAndInlineTables) {
    EXPECT_EQ(cut("a = [1, 2, 3] # c\n", {"a", 0u}), "a = [2, 3] # c\n");
    EXPECT_EQ(cut("a = [1, 2, 3]\n", {"a", 1u}), "a = [1, 3]\n");
    EXPECT_EQ(cut("a = [1, 2, 3]\n", {"a", 2u}), "a = [1, 2]\n");
    EXPECT_EQ(cut("a = [ 1, ]\n", {"a", 0u}), "a = []\n");
    EXPECT_EQ(cut("t = { a = 1, b = [2, 3] }\n", {"t", "a"}), "t = { b = [2, 3] }\n");
    EXPECT_EQ(cut("t = { a = 1, b = [2, 3] }\n", {"t", "b"}), "t = { a = 1 }\n");
    EXPECT_EQ(cut("t = { a = 1, b = [2, 3] }\n", {"t", "b", 0u}), "t = { a = 1, b = [3] }\n");
    EXPECT_EQ(cut("t = { a.b = 1, c = 2, a.d = 3 }\n", {"t", "a"}), "t = { c = 2 }\n");
    EXPECT_EQ(cut("t = { a.b = 1 }\n", {"t", "a", "b"}), "t = {}\n");
    EXPECT_EQ(cut("a = [\n  1, # one\n  2, # two\n]\n", {"a", 0u}), "a = [\n  2, # two\n]\n");
    EXPECT_EQ(cut("a = [\n  1, # one\n  2 # two\n]\n", {"a", 1u}), "a = [\n  1, # one\n]\n");
    EXPECT_EQ(cut("a = [1, 2, # few\n     3]\n", {"a", 1u}), "a = [1, # few\n     3]\n");
    EXPECT_EQ(cut("a = [1, # few\n     3]\n", {"a", 1u}), "a = [1, # few\n     ]\n");
}

TEST(TomlRemove, OfWhatIsNotThereChangesNothing) {
    for (const TomlPath& path : std::vector<TomlPath>{{"x"},
                                                      {"clamp", "x"},
                                                      {"trial", 3u},
                                                      {"trial", "name"},
                                                      {"name", "x"},
                                                      {"clamp", "box", 1u},
                                                      {"clamp", 0u}})
        EXPECT_EQ(cut(beam, path), beam);
    EXPECT_EQ(cut("", {"x"}), "");
    EXPECT_EQ(cut(beam, {}), "the whole file cannot be removed");
}

TEST(TomlAppend, FollowsTheLastElement) {
    EXPECT_EQ(appended(beam, {"trial"}, "name = \"d\"\nrole = \"fit\"\n"),
              beam + "\n[[trial]]\nname = \"d\"\nrole = \"fit\"\n");
    EXPECT_EQ(appended(beam, {"trial", 1u, "load"}, "kind = \"z\""), head + clamp + markers + first +
                                                                         second.substr(0, second.size() - 1) +
                                                                         "[[trial.load]]\nkind = \"z\"\n\n" + third);
    EXPECT_EQ(appended(beam, {"trial", 0u, "load"}, "kind = \"z\"\n"),
              head + clamp + markers + first.substr(0, first.size() - 1) + "[[trial.load]]\nkind = \"z\"\n\n" + second +
                  third);
    EXPECT_EQ(appended("[[t]]\nx = 1\n# spare\n\n# next\n[a]\n", {"t"}, ""),
              "[[t]]\nx = 1\n# spare\n\n[[t]]\n\n# next\n[a]\n");
    EXPECT_EQ(appended("[b]\n[[t]]\nx = 1\n[a]\n", {"t"}, "x = 2"), "[b]\n[[t]]\nx = 1\n[[t]]\nx = 2\n[a]\n");
    EXPECT_EQ(appended("[[t]]\r\nx = 1\r\n", {"t"}, "x = 2\ny = 3\n"),
              "[[t]]\r\nx = 1\r\n\r\n[[t]]\r\nx = 2\r\ny = 3\r\n");
}

TEST(TomlAppend, StartsAnArray) {
    EXPECT_EQ(appended(beam, {"muscle"}, "name = \"upper\"\n"), beam + "\n[[muscle]]\nname = \"upper\"\n");
    EXPECT_EQ(appended("", {"trial"}, "name = \"d\"\n"), "[[trial]]\nname = \"d\"\n");
    EXPECT_EQ(appended("[a]\n[b]\n", {"a", "c"}, "x = 1\n"), "[a]\n[[a.c]]\nx = 1\n[b]\n");
    EXPECT_EQ(appended("a.b = 1\nd = 2\n[b]\n", {"a", "c"}, "x = 1\n"), "a.b = 1\nd = 2\n[[a.c]]\nx = 1\n[b]\n");
}

TEST(TomlAppend, TakesABodyWithSubtables) {
    const std::string body = "name = \"d\"\n\n[[trial.load]]\nkind = \"x\"\n[trial.load.a]\nb = 1\n";
    EXPECT_EQ(appended(beam, {"trial"}, body), beam + "\n[[trial]]\n" + body);
    EXPECT_EQ(appended(beam, {"trial"}, "x = 1\n[other]\n"), "trial[3]: the new lines hold more than one table");
    EXPECT_EQ(appended(beam, {"trial"}, "x = 1\n[[trial]]\n"), "trial[3]: the new lines hold more than one table");
    EXPECT_THAT(appended(beam, {"trial"}, "x = \n"), StartsWith("trial[3]: this is not valid TOML"));
}

TEST(TomlAppend, SaysWhatIsNoArrayOfTables) {
    EXPECT_EQ(appended(beam, {"clamp"}, ""), "clamp: is a table and not an array of tables");
    EXPECT_EQ(appended(beam, {"trial", 3u, "load"}, ""), "trial[3].load: trial[3] does not exist");
    EXPECT_EQ(appended(beam, {"clamp", "box", "x"}, ""),
              "clamp.box.x: is not written as tables with headers, so no table can be appended");
    EXPECT_EQ(appended(beam, {"trial", 1u}, ""), "trial[1]: is no key of an array of tables");
    EXPECT_EQ(appended("t = []\n", {"t"}, ""), "t: is not written as tables with headers, so no table can be appended");
}

TEST(TomlDuplicate, CopiesWithCommentsAndSubtables) {
    EXPECT_EQ(duplicated(beam, {"trial", 0u}), head + clamp + markers + first + first + second + third);
    EXPECT_EQ(duplicated(beam, {"trial", 1u}), head + clamp + markers + first + second + second + third);
    EXPECT_EQ(duplicated(beam, {"trial", 2u}), beam + "\n" + third);
    EXPECT_EQ(duplicated("[[t]]\nx = 1", {"t", 0u}), "[[t]]\nx = 1\n\n[[t]]\nx = 1");
    EXPECT_EQ(duplicated("a = 1\n[[t]]\nx = 1\n[b]\n", {"t", 0u}), "a = 1\n[[t]]\nx = 1\n[[t]]\nx = 1\n[b]\n");
    EXPECT_EQ(duplicated("a = 1\n[[t]]\n# about b\n[b]\n", {"t", 0u}), "a = 1\n[[t]]\n[[t]]\n# about b\n[b]\n");
    EXPECT_EQ(duplicated("a = 1\r\n\r\n[[t]]\r\nx = 1\r\n", {"t", 0u}),
              "a = 1\r\n\r\n[[t]]\r\nx = 1\r\n\r\n[[t]]\r\nx = 1\r\n");
    EXPECT_EQ(duplicated("[[t]]\n[o]\n[t.s]\nx = 1\n[[t]]\n", {"t", 0u}),
              "[[t]]\n[o]\n[t.s]\nx = 1\n\n[[t]]\n[t.s]\nx = 1\n[[t]]\n");
}

TEST(TomlDuplicate, SaysWhatIsNoElement) {
    EXPECT_EQ(duplicated(beam, {"trial"}), "trial: is no element of an array of tables");
    EXPECT_EQ(duplicated(beam, {"trial", 3u}), "trial[3]: is no element of an array of tables");
    EXPECT_EQ(duplicated(beam, {"clamp"}), "clamp: is no element of an array of tables");
    EXPECT_EQ(duplicated(beam, {}), "is no element of an array of tables");
}

}  // namespace
}  // namespace myo::toml
