#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/driver.hpp"

// Letters of names in other scripts, which the fonts do not hold from the start.

namespace myo::ui {
namespace {

using test::Driver;

constexpr const char* cyrillic = "\xd0\xb6";

/// Whether every font of the window's text has a letter; false where none is loaded.
bool is_loaded(ImWchar letter) {
    const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    return !atlas.Fonts.empty() && atlas.Fonts[0]->FindGlyphNoFallback(letter) != nullptr;
}
bool is_cyrillic_loaded() { return is_loaded(0x436); }
/// Without the font that has other scripts there is nothing to load.
bool has_other_scripts() { return is_loaded(0xfffd); }

TEST(Letters, OfARenamedMuscleAreLoaded) {
    Driver driver;
    driver.open_beam();
    if (!has_other_scripts()) GTEST_SKIP() << "skipped: no DejaVu";
    commands::Settings settings = driver.state().settings;
    settings.muscles.resize(1);
    settings.muscles[0].name = "upper";
    driver.workbench->execute(commands::ChangeSettings{settings, "fibres/add"});
    driver.settle();
    EXPECT_FALSE(is_cyrillic_loaded());
    const auto scene = driver.state().scene;
    const std::size_t logged = driver.state().logged;
    settings.muscles[0].name = cyrillic;
    driver.workbench->execute(commands::ChangeSettings{settings, "fibres/name"});
    driver.settle();
    ASSERT_EQ(driver.state().scene, scene);
    ASSERT_EQ(driver.state().logged, logged) << "no message has them loaded";
    EXPECT_TRUE(is_cyrillic_loaded());
}

TEST(Letters, OfLateFilesAreLoadedAlsoWithAnotherTheme) {
    Driver driver;
    if (!has_other_scripts()) GTEST_SKIP() << "skipped: no DejaVu";
    commands::Preferences kept = driver.state().preferences;
    kept.theme = platform::ThemeName::light;
    kept.recent = {std::string("/") + cyrillic};
    driver.workbench->execute(commands::UsePreferences{kept});
    driver.settle();
    EXPECT_TRUE(is_cyrillic_loaded());
}

}  // namespace
}  // namespace myo::ui
