#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>

#include "platform/fonts.hpp"
#include "platform/wide_fonts.hpp"
#include "support/folder.hpp"
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

/// A font of this machine gives the letters of Chinese names; without one the window says what to install.
TEST(Letters, OfChineseNamesAreLoadedOrMissedWithAHint) {
    Driver driver;
    driver.open_beam();
    if (!has_other_scripts()) GTEST_SKIP() << "skipped: no DejaVu";
    commands::Settings settings = driver.state().settings;
    settings.muscles.resize(1);
    settings.muscles[0].name = "\xe8\x87\x82";  // U+81C2, arm
    driver.workbench->execute(commands::ChangeSettings{settings, "fibres/name"});
    driver.settle();
    const auto& log = driver.state().log;
    const auto told = std::count_if(
        log.begin(), log.end(), [](const commands::LogLine& line) { return line.text == platform::wide_font_hint; });
    const bool has_font = !platform::wide_fonts(platform::font_folders()).empty();
    EXPECT_EQ(is_loaded(0x81c2), has_font);
    EXPECT_EQ(told, has_font ? 0 : 1);
}

/// Every letter of an atlas that is made of a font of this machine, in two scripts.
TEST(WideFonts, HaveChineseAndJapaneseLetters) {
    Driver driver;
    if (platform::wide_fonts(platform::font_folders()).empty()) GTEST_SKIP() << "skipped: no CJK font";
    platform::Theme theme = platform::make_theme(platform::ThemeName::dark, 1.0f);
    const std::vector<ImWchar> letters{0x81c2, 0x81c2, 0x3042, 0x3042, 0};
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGuiContext* const own = ImGui::CreateContext();
    ImGui::SetCurrentContext(own);
    platform::load_label_font(theme, letters);
    ASSERT_TRUE(ImGui::GetIO().Fonts->Build());
    EXPECT_TRUE(theme.small->FindGlyphNoFallback(0x81c2)) << "Chinese";
    EXPECT_TRUE(theme.small->FindGlyphNoFallback(0x3042)) << "Japanese";
    ImGui::DestroyContext(own);
    ImGui::SetCurrentContext(before);
}

TEST(WideFonts, AreFoundInAllFoldersTheBestFirst) {
    const myo::test::Folder folder("wide_fonts");
    folder.write("system/truetype/wqy/wqy-microhei.ttc", "");
    folder.write("user/NotoSansCJK-Regular.ttc", "");
    folder.write("user/wqy-microhei.ttc", "");
    folder.write("user/Other.ttf", "");
    const auto system = folder.path() / "system", user = folder.path() / "user";
    EXPECT_EQ(platform::wide_fonts({system, folder.path() / "missing", user}),
              (std::vector<std::string>{(user / "NotoSansCJK-Regular.ttc").string(),
                                        (system / "truetype/wqy/wqy-microhei.ttc").string()}));
    EXPECT_TRUE(platform::wide_fonts({}).empty());
}

}  // namespace
}  // namespace myo::ui
