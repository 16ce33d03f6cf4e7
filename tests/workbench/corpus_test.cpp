#include "support/corpus.hpp"

#include <gtest/gtest.h>

#include "backend/project_file.hpp"
#include "backend/user_files.hpp"
#include "project_values.hpp"

namespace myo::backend {
namespace {

/// Saved by the window of commit 8efc898, with two painted muscles, three effects and its own view.
TEST(Corpus, ProjectHasTheValuesThatTheFormerWindowHeld) {
    const Result<ui::commands::Project> read = read_project_file(test::corpus("beam.myoloop"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->warnings.empty()) << read->warnings.front();
    test::expect_values_of(test::project_values(*read), "project_values.txt");
    ASSERT_EQ(read->settings.muscles.size(), 2u);
    for (const ui::commands::Muscle& muscle : read->settings.muscles) EXPECT_TRUE(muscle.paint) << muscle.name;
    EXPECT_TRUE(std::filesystem::is_regular_file(read->source / "experiment.toml"));
    EXPECT_TRUE(read->settings.own_step) << "runs took the step of the file as it was";
}

TEST(Corpus, PreferencesHaveTheValuesThatTheFormerWindowWrote) {
    const Result<ui::commands::Preferences> read = read_preferences(test::corpus("preferences.toml"));
    ASSERT_TRUE(read) << read.error().text();
    ui::commands::Preferences written;
    written.theme = ui::platform::ThemeName::light;
    written.scale = 1.5f;
    written.layout = {400.0f, 200.0f};
    written.bookmarks = {"/elsewhere"};
    written.step_costs = {{mesh::CellType::hex8, 4608.0, 0.0068}, {mesh::CellType::tet10, 31725.0, 0.125}};
    EXPECT_EQ(*read, written);
}

}  // namespace
}  // namespace myo::backend
