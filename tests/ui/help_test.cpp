#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "help/field_links.hpp"
#include "help/manual_pages.hpp"
#include "help/markdown.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using help::Block;
using test::Driver;

TEST(Markdown, HasHeadingsParagraphsListsCodeAndTables) {
    const std::vector<Block> blocks = help::read_markdown(
        "# A *title*\n\nOne `a_b * c`\nline, [a link](x.md) and **bold**; 2 * 3.\n\n* first\n  goes on\n* second\n"
        "3. third\n\nText.\n\n    M a = f\n    x\n\n```\nraw | text\n```\n\n| a | b |\n|---|---|\n| \\|F\\| | "
        "![p](q.png) |\n");
    ASSERT_EQ(blocks.size(), 9u);
    EXPECT_EQ(blocks[0].kind, Block::Kind::heading);
    EXPECT_EQ(blocks[0].text, "A title");
    EXPECT_EQ(blocks[1].text, "One a_b * c line, a link and bold; 2 * 3.");
    EXPECT_EQ(blocks[2].kind, Block::Kind::item);
    EXPECT_EQ(blocks[2].text, "first goes on");
    EXPECT_EQ(blocks[4].sign, "3.");
    EXPECT_EQ(blocks[6].kind, Block::Kind::code);
    EXPECT_EQ(blocks[6].text, "M a = f\nx");
    EXPECT_EQ(blocks[7].text, "raw | text");
    ASSERT_EQ(blocks[8].rows.size(), 2u);
    EXPECT_EQ(blocks[8].rows[1], (std::vector<std::string>{"|F|", ""}));
}

TEST(Manual, EveryPageIsInTheProgramAndReadable) {
    for (const help::ManualPage& page : help::manual_pages) {
        const std::vector<Block> blocks = help::read_markdown(help::manual_text(page.name));
        ASSERT_GE(blocks.size(), 3u) << page.name;
        EXPECT_EQ(blocks.front().kind, Block::Kind::heading) << page.name;
        for (const Block& block : blocks)
            if (block.kind != Block::Kind::code) {
                EXPECT_EQ(block.text.find("]("), std::string::npos) << block.text;
            }
    }
    EXPECT_TRUE(help::manual_text("no such page").empty());
}

TEST(Manual, EveryLinkOfAFieldIsDefinedThere) {
    for (const help::FieldLink& link : help::field_links()) {
        const std::vector<Block> blocks = help::read_markdown(help::manual_text(link.page));
        EXPECT_LT(help::find_block(blocks, link.phrase), blocks.size()) << link.field << ": " << link.phrase;
    }
    EXPECT_STREQ(help::link_of("model/density")->phrase, "M a = ");
    EXPECT_STREQ(help::link_of("part/0/youngs_modulus")->page, "experiment");
    EXPECT_EQ(help::link_of("picture/width"), nullptr);
}

/// Whether what is shown in the help has this glyph, so that no page has a placeholder.
TEST(Manual, LettersOfAllPagesAreInTheFont) {
    Driver driver;
    driver.settle();
    const ImFont* const font = ImGui::GetIO().FontDefault;
    if (!font->FindGlyphNoFallback(0x3bd)) GTEST_SKIP() << "skipped: neither Inter nor DejaVu is installed";
    for (const help::ManualPage& page : help::manual_pages) {
        const std::string_view text = help::manual_text(page.name);
        for (const char* at = text.data(); at < text.data() + text.size();) {
            unsigned int letter = 0;
            at += ImTextCharFromUtf8(&letter, at, text.data() + text.size());
            if (letter >= 0x20) {
                EXPECT_NE(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)), nullptr)
                    << page.name << ": U+" << std::hex << letter;
            }
        }
    }
}

TEST(Help, TheQuestionMarkOfAFieldOpensItsEquation) {
    Driver driver(1280, 1400);
    driver.open_beam();
    const float view_before = driver.window->viewport().pixels.width();
    driver.click("model/youngs_modulus/help");
    driver.settle();
    ASSERT_TRUE(driver.has("help/text"));
    EXPECT_TRUE(driver.has("help/page"));
    EXPECT_LT(driver.window->viewport().pixels.width(), view_before) << "the help lies beside the view";
    driver.click("help/close");
    driver.settle();
    EXPECT_FALSE(driver.has("help/text"));
    EXPECT_EQ(driver.window->viewport().pixels.width(), view_before);
}

TEST(Help, StepsOfTheTutorialTickThemselves) {
    Driver driver;
    driver.key(ImGuiKey_A);  // no shortcut
    driver.click("menu/help");
    driver.click("menu/help.tutorial");
    driver.settle();
    ASSERT_TRUE(driver.has("help/step/open"));
    EXPECT_FALSE(driver.has("help/done/open"));
    driver.open_beam();
    driver.settle();
    EXPECT_TRUE(driver.has("help/done/open"));
    EXPECT_TRUE(driver.has("help/done/mesh"));
    EXPECT_FALSE(driver.has("help/done/paint"));
    EXPECT_FALSE(driver.has("help/done/run"));
    driver.click("help/step/paint");
    EXPECT_EQ(driver.window->task(), commands::Task::fibres);
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    driver.settle();
    EXPECT_TRUE(driver.has("help/done/run"));
    EXPECT_FALSE(driver.has("help/done/calibrate"));
    driver.workbench->execute(commands::Calibrate{});
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::Diagnose{});
    ASSERT_TRUE(driver.wait_for_job());
    driver.settle();
    EXPECT_TRUE(driver.has("help/done/calibrate"));
    EXPECT_TRUE(driver.has("help/done/diagnose"));
}

TEST(Help, FitsSmallWindowsAndLargeLetters) {
    Driver driver(1000, 640);
    driver.open_beam();
    for (const char* part : {"tutorial", "manual", "keys"})
        for (const float scale : {1.0f, 2.0f}) {
            driver.workbench->execute(commands::SetTheme{platform::ThemeName::light, scale});
            ASSERT_TRUE(driver.window->show_panel(part));
            driver.settle();
            EXPECT_LE(driver.item("help/close").highest.x, 1000.0f) << part << scale;
            EXPECT_GT(driver.window->viewport().pixels.width(), 100.0f) << part << scale;
        }
}

TEST(Help, EveryShortcutIsListed) {
    Driver driver(1280, 2000);
    driver.open_beam();
    driver.key(platform::key_k, {.ctrl = true});
    driver.type("shortcuts");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    for (const panels::Action& action : panels::all_actions())
        if (*action.shortcut.label) {
            EXPECT_TRUE(driver.has("help/key/" + action.id)) << action.id;
        }
}

TEST(Palette, FindsEveryPanelAndTool) {
    Driver driver(1280, 1400);
    driver.open_beam();
    for (const char* words : {"tool measure distances", "tool place markers", "tool paint", "panel support",
                              "panel material", "help theory", "help tutorial"}) {
        driver.key(platform::key_k, {.ctrl = true});
        driver.type(words);
        driver.settle();
        bool found = false;
        for (const auto& [item, place] : driver.window->items().all())
            found = found || (item.rfind("palette/", 0) == 0 && item != "palette/text");
        EXPECT_TRUE(found) << words;
        driver.key(ImGuiKey_Escape);
        driver.settle();
    }
}

}  // namespace
}  // namespace myo::ui
