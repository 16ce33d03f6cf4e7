#include "toml/toml_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "toml/toml_edit_document.hpp"
#include "toml/toml_text.hpp"

namespace myo::toml {
namespace {

using testing::StartsWith;

/// The edited text, or the error's text.
std::string text_of(const Result<std::string>& edited) { return edited ? *edited : edited.error().text(); }

std::string set(const std::string& document, const TomlPath& path, const std::string& value) {
    return text_of(with_value(document, path, value));
}

std::string removed(const std::string& document, const TomlPath& path) { return text_of(without(document, path)); }

std::string renamed(const std::string& document, const TomlPath& path, const std::string& key) {
    return text_of(with_renamed_key(document, path, key));
}

const std::string experiment =
    "schema = \"experiment/1\"\n"
    "# Made by hand.\n"
    "\n"
    "[material]\n"
    "density_kg_m3 = 1070.0   # scale\n"
    "calibrate = [\"youngs_modulus\", \"damping\"]\n"
    "\n"
    "# Motion capture\n"
    "[markers]\n"
    "noise_m = 1.0e-4\n"
    "[markers.rest_m]\n"
    "tip = [0.1, 0.0, 0.02]\n"
    "\"R\u00fccken 1\" = [0.0, 0.0, 0.02] # \u00fcber der Mitte\n"
    "\n"
    "[[trial]]\n"
    "name = \"release\"\n"
    "follows = { muscle = \"upper\", ratio = -1.0 }   # antagonist\n"
    "\n"
    "[[trial]]\n"
    "name = \"pluck\"\n"
    "[[trial.load]]\n"
    "kind = \"force\"\n";

/// The experiment with one part replaced.
std::string experiment_with(const std::string& before, const std::string& after) {
    std::string text = experiment;
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return text.replace(at, before.size(), after);
}

TEST(TomlSet, ReplacesAValueAndKeepsItsComment) {
    EXPECT_EQ(set(experiment, {"material", "density_kg_m3"}, "900.0"),
              experiment_with("1070.0   # scale", "900.0   # scale"));
    EXPECT_EQ(set(experiment, {"markers", "rest_m", "R\u00fccken 1"}, "[1.0, 2.0, 3.0]"),
              experiment_with("[0.0, 0.0, 0.02] #", "[1.0, 2.0, 3.0] #"));
    EXPECT_EQ(set(experiment, {"markers", "rest_m", "R\u00fccken 1", 2u}, "3.0"),
              experiment_with("[0.0, 0.0, 0.02] #", "[0.0, 0.0, 3.0] #"));
    EXPECT_EQ(set(experiment, {"trial", 0u, "follows", "ratio"}, "0.5"), experiment_with("-1.0", "0.5"));
    EXPECT_EQ(set(experiment, {"trial", 1u, "load", 0u, "kind"}, "\"mass\""), experiment_with("\"force\"", "\"mass\""));
    EXPECT_EQ(set(experiment, {"trial", 0u, "follows"}, "\"upper\""),
              experiment_with("{ muscle = \"upper\", ratio = -1.0 }", "\"upper\""));
}

TEST(TomlSet, AddsAKeyAtTheEndOfItsTable) {
    EXPECT_EQ(set(experiment, {"material", "damping_s"}, "0.1"),
              experiment_with("\"damping\"]\n", "\"damping\"]\ndamping_s = 0.1\n"));
    EXPECT_EQ(set(experiment, {"markers", "max_standoff_m"}, "0.1"),
              experiment_with("1.0e-4\n", "1.0e-4\nmax_standoff_m = 0.1\n"));
    EXPECT_EQ(set(experiment, {"trial", 0u, "role"}, "\"fit\""),
              experiment_with("# antagonist\n", "# antagonist\nrole = \"fit\"\n"));
    EXPECT_EQ(set(experiment, {"markers", "rest_m", "B\u00e4r"}, "1.0"),
              experiment_with("Mitte\n", "Mitte\n\"B\u00e4r\" = 1.0\n"));
    EXPECT_EQ(set(experiment, {"name"}, "\"x\""), experiment_with("/1\"\n", "/1\"\nname = \"x\"\n"));
    EXPECT_EQ(set(experiment, {"trial", 0u, "follows", "lag_s"}, "0.1"),
              experiment_with("-1.0 }", "-1.0, lag_s = 0.1 }"));
    EXPECT_EQ(set(experiment, {"material", "calibrate", 2u}, "\"x\""),
              experiment_with("\"damping\"]", "\"damping\", \"x\"]"));
    EXPECT_EQ(set("[a]\n\n[b]\n", {"a", "x"}, "1"), "[a]\nx = 1\n\n[b]\n");
    EXPECT_EQ(set("[a]\n  x = 1\n[b]\n", {"a", "y"}, "2"), "[a]\n  x = 1\n  y = 2\n[b]\n");
    EXPECT_EQ(set("# file\n\n# a\n[a]\n", {"x"}, "1"), "# file\n\nx = 1\n\n# a\n[a]\n");
}

TEST(TomlSet, AddsTablesBehindTheirParent) {
    EXPECT_EQ(set(experiment, {"registration", "known"}, "true"), experiment + "\n[registration]\nknown = true\n");
    EXPECT_EQ(set(experiment, {"material", "fibre", "a"}, "1"),
              experiment_with("\"damping\"]\n", "\"damping\"]\n[material.fibre]\na = 1\n"));
    EXPECT_EQ(set(experiment, {"markers", "weights", "tip"}, "1"),
              experiment_with("Mitte\n", "Mitte\n[markers.weights]\ntip = 1\n"));
    EXPECT_EQ(set(experiment, {"trial", 0u, "load", 0u, "kind"}, "\"mass\""),
              experiment_with("# antagonist\n", "# antagonist\n[[trial.load]]\nkind = \"mass\"\n"));
    EXPECT_EQ(set(experiment, {"trial", 2u, "name"}, "\"third\""), experiment + "\n[[trial]]\nname = \"third\"\n");
    EXPECT_EQ(set("[a]\nx = 1\n\n[a.b]\ny = 1\n", {"a", "c", "z"}, "1"),
              "[a]\nx = 1\n\n[a.b]\ny = 1\n\n[a.c]\nz = 1\n");
    EXPECT_EQ(set("[x]\n\n# places\n[a.b]\ny = 1\n", {"a", "z"}, "1"), "[x]\n\n[a]\nz = 1\n# places\n[a.b]\ny = 1\n");
}

TEST(TomlSet, StartsAnEmptyDocument) {
    EXPECT_EQ(set("", {"a"}, "1"), "a = 1\n");
    EXPECT_EQ(set("", {"a", "b c", "d"}, "1"), "[a.\"b c\"]\nd = 1\n");
    EXPECT_EQ(set("", {"trial", 0u, "name"}, "\"x\""), "[[trial]]\nname = \"x\"\n");
    EXPECT_EQ(set("# only a comment", {"a"}, "1"), "# only a comment\na = 1");
}

TEST(TomlSet, ExtendsDottedKeys) {
    const std::string dotted = "[a]\nb . c = 1\nb.\"d\".e = 2\nf = 3\n";
    EXPECT_EQ(set(dotted, {"a", "b", "d", "e"}, "7"), "[a]\nb . c = 1\nb.\"d\".e = 7\nf = 3\n");
    EXPECT_EQ(set(dotted, {"a", "b", "x"}, "7"), "[a]\nb . c = 1\nb.\"d\".e = 2\nb.x = 7\nf = 3\n");
    EXPECT_EQ(set(dotted, {"a", "b", "d", "x"}, "7"), "[a]\nb . c = 1\nb.\"d\".e = 2\nb.d.x = 7\nf = 3\n");
    EXPECT_EQ(set("t = { a.b = 1 }\n", {"t", "a", "c"}, "2"), "t = { a.b = 1, a.c = 2 }\n");
    EXPECT_EQ(set("t = { a.b = 1 }\n", {"t", "a", "b"}, "2"), "t = { a.b = 2 }\n");
    EXPECT_EQ(set("t = {}\n", {"t", "a"}, "2"), "t = { a = 2 }\n");
}

TEST(TomlSet, ReplacesSeveralLinesAsAWhole) {
    EXPECT_EQ(set("a = [ # list\n  1, # one ]\n  2,\n] # end\nb = 1\n", {"a"}, "[3]"), "a = [3] # end\nb = 1\n");
    EXPECT_EQ(set("a = \"\"\"\n# no comment\n[b]\n\\\"\"\"\"\"\" # end\nb = 1\n", {"a"}, "\"x\""),
              "a = \"x\" # end\nb = 1\n");
    EXPECT_EQ(set("a = '''\n\\'''''\nb = 1\n", {"a"}, "1"), "a = 1\nb = 1\n");
    EXPECT_EQ(set("a = 1979-05-27 07:32:00 # then\n", {"a"}, "1"), "a = 1 # then\n");
    EXPECT_EQ(set("a = '#' # b\n", {"a"}, "'\"'"), "a = '\"' # b\n");
}

TEST(TomlSet, AppendsToArraysOfSeveralLines) {
    EXPECT_EQ(set("a = [\n  1, # one\n  2, # two\n]\n", {"a", 2u}, "3"), "a = [\n  1, # one\n  2, # two\n  3,\n]\n");
    EXPECT_EQ(set("a = [\n  1, # one\n  2 # two\n]\n", {"a", 2u}, "3"), "a = [\n  1, # one\n  2, # two\n  3\n]\n");
    EXPECT_EQ(set("a = [1,\n     2]\n", {"a", 2u}, "3"), "a = [1,\n     2,\n     3]\n");
    EXPECT_EQ(set("a = [\n]\n", {"a", 0u}, "3"), "a = [3\n]\n");
    EXPECT_EQ(set("a = []\n", {"a", 0u}, "3"), "a = [3]\n");
    EXPECT_EQ(set("a = [1]\n", {"a", 1u, "b", "c", 0u, "d"}, "3"), "a = [1, { b.c = [{ d = 3 }] }]\n");
    EXPECT_EQ(set("[t]\n[u]\n", {"t", "a", 0u, 0u}, "3"), "[t]\na = [[3]]\n[u]\n");
}

TEST(TomlSet, KeepsLineEnds) {
    EXPECT_EQ(set("a = 1\r\n[b]\r\nx = 1 # c\r\n\r\n[c]\r\n", {"b", "y"}, "[\n1]"),
              "a = 1\r\n[b]\r\nx = 1 # c\r\ny = [\r\n1]\r\n\r\n[c]\r\n");
    EXPECT_EQ(set("a = 1\r\n[b]\r\nx = 1 # c\r\n", {"c", "y"}, "2"),
              "a = 1\r\n[b]\r\nx = 1 # c\r\n\r\n[c]\r\ny = 2\r\n");
    EXPECT_EQ(set("a = 1\r\nb = 2", {"c"}, "3"), "a = 1\r\nb = 2\r\nc = 3");
    EXPECT_EQ(set("\xEF\xBB\xBF"
                  "a = 1\n",
                  {"a"}, "2"),
              "\xEF\xBB\xBF"
              "a = 2\n");
    EXPECT_EQ(set("\xEF\xBB\xBF"
                  "[a]\n",
                  {"b"}, "2"),
              "\xEF\xBB\xBF"
              "b = 2\n\n[a]\n");
}

TEST(TomlSet, OfTheSameValueChangesNothing) {
    for (const double number : {0.0, -0.0, 1.0, 0.1, 1e-4, 1.0 / 3.0, -9.81, 25000.0, 1e300, 5e-324}) {
        const std::string text = "# c\n[a]\nx   =  " + toml_number(number) + "  # unit\ny = [" + toml_number(number) +
                                 "]\n";
        EXPECT_EQ(set(text, {"a", "x"}, toml_number(number)), text);
        EXPECT_EQ(set(text, {"a", "y", 0u}, toml_number(number)), text);
    }
}

TEST(TomlSet, SaysWhatCannotBeSet) {
    EXPECT_EQ(set(experiment, {"trial", 4u, "name"}, "1"), "trial[4].name: trial has 2 elements");
    EXPECT_EQ(set(experiment, {"trial", 2u, "load", 0u, "kind"}, "1"),
              "trial[2].load[0].kind: trial[2] does not exist");
    EXPECT_EQ(set(experiment, {"trial", "name"}, "1"), "trial.name: trial is an array, so it has no name");
    EXPECT_EQ(set(experiment, {"schema", "x"}, "1"), "schema.x: schema is a string, so it has no x");
    EXPECT_EQ(set(experiment, {"markers", 0u}, "1"), "markers[0]: markers is a table, so it has no numbered elements");
    EXPECT_EQ(set(experiment, {"markers"}, "1"), "markers: is a table with lines of its own, which no value replaces");
    EXPECT_EQ(set(experiment, {"trial", 2u}, "1"),
              "trial[2]: is an element of an array of tables, which no value replaces");
    EXPECT_EQ(set("t = { a.b = 1 }\n", {"t", "a"}, "2"), "t.a: is a table with dotted keys, which no value replaces");
    EXPECT_EQ(set(experiment, {}, "1"), "the whole file is no value to be set");
    for (const char* value : {"", "word", "1 # c", " 1", "1\nb = 2", "1\n[x]", "[1", "1, 2"})
        EXPECT_EQ(set(experiment, {"name"}, value),
                  "name: \"" + std::string(value) + "\" is not one value in TOML syntax");
}

TEST(TomlEdits, SayWhereADocumentIsNotValid) {
    for (const char* document : {"a = 1\n\na = 2\n", "a = 1\n\nb = = 2\n", "[t]\nx = 1\n[t]\n"}) {
        EXPECT_THAT(set(document, {"b"}, "1"), StartsWith("line 3: this is not valid TOML: "));
        EXPECT_THAT(removed(document, {"b"}), StartsWith("line 3: "));
        EXPECT_THAT(renamed(document, {"a"}, "c"), StartsWith("line 3: "));
        EXPECT_THAT(text_of(with_appended_table(document, {"b"}, "")), StartsWith("line 3: "));
        EXPECT_THAT(text_of(with_duplicated_table(document, {"b", 0u})), StartsWith("line 3: "));
    }
}

TEST(TomlEdits, ReturnNoTextWithOtherValues) {
    const TomlValue expected = *parse_toml("a = 1\nb = 2\n", "");
    EXPECT_TRUE(checked("b = 2\na = 1 # c\n", expected, {"a"}));
    for (const char* text : {"a = 1\n", "a = 1\nb = 3\n", "a = 1\nb = 2\nc = 3\n", "a = 1\nb = \n"})
        EXPECT_EQ(text_of(checked(text, expected, {"a"})),
                  "a: cannot be changed without changing other parts of the file");
}

TEST(TomlRename, ChangesTheKeyOnly) {
    EXPECT_EQ(renamed(experiment, {"markers", "rest_m", "tip"}, "end"), experiment_with("tip =", "end ="));
    EXPECT_EQ(renamed(experiment, {"markers", "rest_m", "R\u00fccken 1"}, "back"),
              experiment_with("\"R\u00fccken 1\"", "back"));
    EXPECT_EQ(renamed(experiment, {"trial", 0u, "follows", "ratio"}, "a b"), experiment_with("ratio", "\"a b\""));
    EXPECT_EQ(renamed(experiment, {"schema"}, "schema"), experiment);
}

TEST(TomlRename, ReachesAllHeadersAndDottedKeys) {
    EXPECT_EQ(renamed("[a]\n[a.b]\n[[c]]\n[[c.a]]\n[[c]]\n[[c.a]]\n", {"a"}, "x"),
              "[x]\n[x.b]\n[[c]]\n[[c.a]]\n[[c]]\n[[c.a]]\n");
    EXPECT_EQ(renamed("[[c]]\n[[c.a]]\n[[c]]\n[[c.a]]\n[c.a.d]\n", {"c", 1u, "a"}, "x"),
              "[[c]]\n[[c.a]]\n[[c]]\n[[c.x]]\n[c.x.d]\n");
    EXPECT_EQ(renamed("a.b = 1\na.c = 2\n", {"a"}, "x"), "x.b = 1\nx.c = 2\n");
    EXPECT_EQ(renamed("t = { a.b = 1, a.c = 2 }\n", {"t", "a"}, "x"), "t = { x.b = 1, x.c = 2 }\n");
}

TEST(TomlRename, SaysWhatCannotBeRenamed) {
    EXPECT_EQ(renamed(experiment, {"markers", "rest_m", "none"}, "x"), "markers.rest_m.none: is no key of a table");
    EXPECT_EQ(renamed(experiment, {"trial", 0u}, "x"), "trial[0]: is no key of a table");
    EXPECT_EQ(renamed(experiment, {}, "x"), "is no key of a table");
    EXPECT_EQ(renamed(experiment, {"markers"}, "trial"), "markers: the name \"trial\" is taken");
}

TEST(TomlKey, IsQuotedIfNeeded) {
    EXPECT_EQ(toml_key("rest_m-1"), "rest_m-1");
    EXPECT_EQ(toml_key(""), "\"\"");
    EXPECT_EQ(toml_key("a.b"), "\"a.b\"");
    EXPECT_EQ(toml_key("R\u00fccken"), "\"R\u00fccken\"");
}

}  // namespace
}  // namespace myo::toml
