#include "backend/marker_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "toml/toml_path.hpp"
#include "toml/toml_value.hpp"

// A marker is renamed wherever the declaration names it, and nothing else is touched.

namespace myo::backend::marker_edit_test {
namespace {

using testing::HasSubstr;
using toml::TomlValue;

const std::string markers = R"([markers.rest_m]
tip = [0.1, 0.0, 0.0]  # at the end
middle = [0.05, 0.0, 0.0]
[markers.probe_m]
spy = [0.02, 0.0, 0.0]
[markers.fixed_m]
base = [0.0, 0.0, 0.0]
)";

const std::string trial = R"([[trial]]
name = "tip"
trace = "tip.csv"
columns = { markers = ["tip", "middle"], unit = "m", rate_Hz = 100 }
[[trial.repair]]
kind = "swap"
marker = "middle"
with = "tip"
[[trial.repair]]
kind = "cut"
marker = "tip"
[[trial.goal]]
marker = "middle"
[[trial.goal]]
marker = "tip"
[[trial]]
name = "second"
[[trial.goal]]
marker = "tip"
[[effect]]
id = "marker_swap"
markers = ["middle", "tip"]
[[effect]]
id = "marker_offset"
marker = "tip"
note = "tip"
)";

std::string renamed(const std::string& text, const std::string& name, const std::string& wanted) {
    const Result<std::string> result = with_renamed_marker(text, name, wanted);
    EXPECT_TRUE(result) << result.error().text();
    return result ? *result : "";
}

/// Text at a path; "none" if there is nothing.
std::string text_at(const std::string& document, const toml::TomlPath& path) {
    const Result<TomlValue> read = toml::parse_toml(document, "");
    EXPECT_TRUE(read) << document;
    const TomlValue* const value = read ? toml::find_at(*read, path) : nullptr;
    return value != nullptr ? value->text : "none";
}

bool has(const std::string& document, const toml::TomlPath& path) {
    const Result<TomlValue> read = toml::parse_toml(document, "");
    return read && toml::find_at(*read, path) != nullptr;
}

TEST(MarkerEdit, EveryPlaceThatNamesAMarkerFollows) {
    const std::string text = renamed(markers + trial, "tip", "end");
    EXPECT_TRUE(has(text, {"markers", "rest_m", "end"}));
    EXPECT_FALSE(has(text, {"markers", "rest_m", "tip"}));
    EXPECT_EQ(text_at(text, {"trial", 0u, "columns", "markers", 0u}), "end");
    EXPECT_EQ(text_at(text, {"trial", 0u, "columns", "markers", 1u}), "middle");
    EXPECT_EQ(text_at(text, {"trial", 0u, "repair", 0u, "with"}), "end");
    EXPECT_EQ(text_at(text, {"trial", 0u, "repair", 0u, "marker"}), "middle");
    EXPECT_EQ(text_at(text, {"trial", 0u, "repair", 1u, "marker"}), "end");
    EXPECT_EQ(text_at(text, {"trial", 0u, "goal", 0u, "marker"}), "middle");
    EXPECT_EQ(text_at(text, {"trial", 0u, "goal", 1u, "marker"}), "end");
    EXPECT_EQ(text_at(text, {"trial", 1u, "goal", 0u, "marker"}), "end");
    EXPECT_EQ(text_at(text, {"effect", 0u, "markers", 0u}), "middle");
    EXPECT_EQ(text_at(text, {"effect", 0u, "markers", 1u}), "end");
    EXPECT_EQ(text_at(text, {"effect", 1u, "marker"}), "end");
    // The trial and the note of this name, the kinds of repairs and the comment stay.
    EXPECT_EQ(text_at(text, {"trial", 0u, "name"}), "tip");
    EXPECT_EQ(text_at(text, {"trial", 0u, "trace"}), "tip.csv");
    EXPECT_EQ(text_at(text, {"effect", 1u, "note"}), "tip");
    EXPECT_EQ(text_at(text, {"trial", 0u, "repair", 0u, "kind"}), "swap");
    EXPECT_THAT(text, HasSubstr("# at the end"));
}

/// Recordings keep the former name, which becomes the label; a marker with a label of its own keeps that.
TEST(MarkerEdit, TheLabelInRecordingsStays) {
    const std::string once = renamed(markers + trial, "tip", "end");
    EXPECT_EQ(text_at(once, {"markers", "labels", "end"}), "tip");
    const std::string twice = renamed(once, "end", "last");
    EXPECT_EQ(text_at(twice, {"markers", "labels", "last"}), "tip");
    EXPECT_FALSE(has(twice, {"markers", "labels", "end"}));
    const std::string labelled = renamed(markers + "[markers.labels]\ntip = \"T1\"\n" + trial, "tip", "end");
    EXPECT_EQ(text_at(labelled, {"markers", "labels", "end"}), "T1");
    EXPECT_FALSE(has(labelled, {"markers", "labels", "tip"}));
    // Without a recording, and for a probe, nothing keeps the former name.
    const std::string planned = renamed(markers + "[[trial]]\nname = \"plan\"\n", "tip", "end");
    EXPECT_FALSE(has(planned, {"markers", "labels"}));
    const std::string probe = renamed(markers + trial, "spy", "watch");
    EXPECT_TRUE(has(probe, {"markers", "probe_m", "watch"}));
    EXPECT_FALSE(has(probe, {"markers", "labels"}));
}

TEST(MarkerEdit, NamesThatNeedQuotesAreQuoted) {
    const std::string text = renamed(markers + trial, "tip", "left tip, \"A\"");
    EXPECT_TRUE(has(text, {"markers", "rest_m", "left tip, \"A\""}));
    EXPECT_EQ(text_at(text, {"effect", 1u, "marker"}), "left tip, \"A\"");
    EXPECT_EQ(renamed(renamed(markers, "tip", "a b"), "a b", "tip"), markers) << "and back";
}

TEST(MarkerEdit, TakenAndUnknownNamesAreRefused) {
    for (const char* taken : {"middle", "spy", "base", "tip"}) {
        const Result<std::string> result = with_renamed_marker(markers + trial, "tip", taken);
        ASSERT_FALSE(result) << taken;
        EXPECT_EQ(result.error().text(), "there is a marker \"" + std::string(taken) + "\" already");
    }
    for (const char* unknown : {"elbow", "", "base"})
        EXPECT_FALSE(with_renamed_marker(markers + trial, unknown, "end")) << unknown;
    EXPECT_FALSE(with_renamed_marker("[markers.rest_m\n", "tip", "end"));
    EXPECT_FALSE(with_renamed_marker("", "tip", "end"));
}

}  // namespace
}  // namespace myo::backend::marker_edit_test
