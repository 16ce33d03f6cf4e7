#include "toml/toml_override.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/folder.hpp"

namespace myo::toml {
namespace {

using testing::ElementsAre;

class Override : public testing::Test {
protected:
    Override() : folder_("toml_override") {
        folder_.write("e.toml",
                      "name = \"beam\"\n[material]\ndensity_kg_m3 = 1000\n"
                      "[[trial]]\nname = \"release\"\nstart_s = 0.5\n[[trial]]\nname = \"step\"\n"
                      "[[effect]]\nid = \"gravity_tilt\"\n[grid]\nrows = [[1, 2], [3, 4]]\n");
        document_ = *read_toml(folder_.path() / "e.toml");
    }

    /// The message of an override that is refused; empty if it is not.
    std::string refused(const std::string& key, const std::string& value) {
        const Result<void> done = override_toml(document_, key, value);
        if (done) return {};
        EXPECT_EQ(done.error().where, "--set");
        return done.error().what;
    }

    const TomlValue& trial(std::size_t i) const { return document_.find("trial")->items[i]; }

    test::Folder folder_;
    TomlValue document_;
};

TEST_F(Override, ReplacesAValue) {
    ASSERT_EQ(refused("material.density_kg_m3", "1234.5"), "");
    const TomlValue& density = *document_.find("material")->find("density_kg_m3");
    EXPECT_EQ(density.number, 1234.5);
    EXPECT_EQ(density.where, "--set");
    ASSERT_EQ(refused("name", "fish tail"), "name: \"fish tail\" is not one value in TOML syntax");
    EXPECT_EQ(document_.find("name")->text, "beam");
    ASSERT_EQ(refused("name", "fish"), "");
    EXPECT_EQ(document_.find("name")->text, "fish");
}

TEST_F(Override, FindsElementsByNumberNameAndId) {
    ASSERT_EQ(refused("trial[1].start_s", "2"), "");
    EXPECT_EQ(trial(1).find("start_s")->number, 2.0);
    EXPECT_EQ(trial(0).find("start_s")->number, 0.5);
    ASSERT_EQ(refused("trial.release.start_s", "0.75"), "");
    EXPECT_EQ(trial(0).find("start_s")->number, 0.75);
    ASSERT_EQ(refused("effect.gravity_tilt.tilt_deg", "3"), "");
    EXPECT_EQ(document_.find("effect")->items[0].find("tilt_deg")->number, 3.0);
    ASSERT_EQ(refused("grid.rows[1][0]", "9"), "");
    EXPECT_EQ(document_.find("grid")->find("rows")->items[1].items[0].number, 9.0);
    EXPECT_EQ(document_.find("grid")->find("rows")->items[0].items[0].number, 1.0);
}

TEST_F(Override, CreatesTablesAndAppendsOneElement) {
    ASSERT_EQ(refused("registration.known", "false"), "");
    EXPECT_FALSE(document_.find("registration")->find("known")->truth);
    EXPECT_EQ(document_.find("registration")->where, "--set");
    ASSERT_EQ(refused("trial[2].name", "third"), "");
    ASSERT_EQ(document_.find("trial")->items.size(), 3u);
    EXPECT_EQ(trial(2).find("name")->text, "third");
    ASSERT_EQ(refused("muscle[0].name", "left"), "");
    EXPECT_EQ(document_.find("muscle")->items[0].find("name")->text, "left");
    EXPECT_THAT(document_.keys, ElementsAre("name", "material", "trial", "effect", "grid", "registration", "muscle"));
}

TEST_F(Override, TakesAQuotedNameThatContainsDots) {
    ASSERT_EQ(refused("markers.\"tip.left\"", "[0, 0, 1]"), "");
    EXPECT_EQ(document_.find("markers")->find("tip.left")->items[2].number, 1.0);
}

TEST_F(Override, SaysWhichElementIsMissing) {
    EXPECT_EQ(refused("trial[3].start_s", "1"), "trial[3].start_s: trial has 2 elements");
    EXPECT_EQ(refused("trial.relaese.start_s", "1"),
              "trial.relaese.start_s: no trial is called \"relaese\"; the closest name is \"release\"");
    EXPECT_EQ(refused("trial.quite_another.start_s", "1"),
              "trial.quite_another.start_s: no trial is called \"quite_another\"");
    EXPECT_EQ(refused("name.first", "1"), "name.first: name is a string, so it has no first");
    EXPECT_EQ(refused("material[0]", "1"), "material[0]: material has no elements");
}

TEST_F(Override, RefusesMalformedKeys) {
    for (const char* key : {"", ".", "a.", ".a", "a..b", "a[", "a[x]", "a[1", "a[-1]", "a[1]b", "\"open", "\"\".a"})
        EXPECT_EQ(refused(key, "1"),
                  std::string(key) + ": is not a key such as material.density_kg_m3 or trial[0].start_s");
}

}  // namespace
}  // namespace myo::toml
