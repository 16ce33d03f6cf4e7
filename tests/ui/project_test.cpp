#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "panels/palette.hpp"
#include "panels/start_page.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

void edit(Driver& driver) {
    commands::Settings settings = driver.state().settings;
    settings.density_kg_m3 += 30.0;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.settle();
}

TEST(Project, IsSavedUnderANameAndOpenedAgain) {
    Driver driver;
    driver.open_beam();
    EXPECT_FALSE(driver.state().unsaved());
    edit(driver);
    driver.workbench->execute(commands::ChooseTrial{1});
    EXPECT_TRUE(driver.state().unsaved());
    driver.key(ui::platform::key_s, {.ctrl = true});
    ASSERT_TRUE(driver.has("browser/name")) << "a project that has no file yet asks for one";
    driver.click("browser/open");
    ASSERT_EQ(driver.backend->projects.size(), 1u);
    const auto file = driver.state().project;
    EXPECT_EQ(file.extension(), commands::project_ending);
    EXPECT_FALSE(driver.state().unsaved());
    const commands::Settings saved = driver.state().settings;
    edit(driver);
    driver.key(ui::platform::key_s, {.ctrl = true});
    EXPECT_FALSE(driver.has("browser/name"));
    EXPECT_FALSE(driver.state().unsaved());
    EXPECT_EQ(driver.backend->projects.at(file).settings.density_kg_m3, saved.density_kg_m3 + 30.0);

    Driver again;
    again.backend->projects = driver.backend->projects;
    again.window->open(file);
    ASSERT_TRUE(again.wait_for_job());
    ASSERT_TRUE(again.state().scene) << again.state().log.back().text;
    EXPECT_EQ(again.state().settings, driver.state().settings);
    EXPECT_EQ(again.state().trial, 1);
    EXPECT_EQ(again.state().project, file);
    EXPECT_FALSE(again.state().unsaved());
    ASSERT_TRUE(again.state().body);
}

TEST(Project, WarnsOfWhatIsMissingWhenItIsOpened) {
    Driver driver;
    driver.open_beam();
    edit(driver);
    driver.workbench->execute(commands::SaveAs{"/arm.myoloop"});
    Driver again;
    again.backend->projects = driver.backend->projects;
    again.backend->projects.begin()->second.warnings = {"The paint of muscle \"upper\" is lost."};
    again.window->open(again.backend->projects.begin()->first);
    ASSERT_TRUE(again.wait_for_job());
    const auto& log = again.state().log;
    EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const auto& entry) {
        return entry.level == commands::LogLevel::warning && entry.text == "The paint of muscle \"upper\" is lost.";
    }));
    EXPECT_TRUE(again.state().scene);
}

TEST(Project, AsksBeforeUnsavedChangesAreLost) {
    Driver driver;
    driver.open_beam();
    edit(driver);
    const auto scene = driver.state().scene;
    driver.window->open("/beam");
    driver.settle();
    ASSERT_TRUE(driver.has("unsaved/cancel"));
    driver.click("unsaved/cancel");
    EXPECT_EQ(driver.state().scene, scene);
    EXPECT_TRUE(driver.state().unsaved());
    driver.key(ui::platform::key_q, {.ctrl = true});
    ASSERT_TRUE(driver.has("unsaved/save"));
    driver.click("unsaved/save");
    ASSERT_TRUE(driver.has("browser/open"));
    EXPECT_FALSE(driver.state().quit);
    driver.click("browser/cancel");
    EXPECT_FALSE(driver.state().quit) << "who gives up saving has not left";
    driver.key(ui::platform::key_q, {.ctrl = true});
    driver.click("unsaved/save");
    driver.click("browser/open");
    EXPECT_TRUE(driver.state().quit);
    EXPECT_EQ(driver.backend->projects.size(), 1u);

    Driver other;
    other.open_beam();
    edit(other);
    other.window->open("/body.stl");
    other.settle();
    other.click("unsaved/discard");
    EXPECT_TRUE(other.state().unit_question) << "what was asked for goes on";
}

TEST(Project, SaysWhyItCannotBeSaved) {
    Driver driver;
    driver.open_beam();
    edit(driver);
    driver.workbench->execute(commands::SaveAs{"/forbidden/x.myoloop"});
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
    EXPECT_TRUE(driver.state().unsaved());
}

TEST(Project, KeepsItsFileFromOtherWindowsWhenItCannotBeSavedElsewhere) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(commands::SaveAs{"/arm.myoloop"});
    const std::set<std::filesystem::path> arm{"/arm.myoloop"};
    EXPECT_EQ(driver.backend->claimed, arm);
    driver.workbench->execute(commands::SaveAs{"/forbidden/x.myoloop"});
    EXPECT_EQ(driver.state().project, "/arm.myoloop");
    EXPECT_EQ(driver.backend->claimed, arm);
    driver.backend->open_elsewhere["/leg.myoloop"] = "leg.myoloop is open in another window of Myoloop, process 7";
    driver.workbench->execute(commands::SaveAs{"/leg.myoloop"});
    EXPECT_EQ(driver.backend->claimed, arm);
    driver.workbench->execute(commands::SaveAs{"/hand.myoloop"});
    EXPECT_EQ(driver.backend->claimed, std::set<std::filesystem::path>{"/hand.myoloop"});
}

TEST(Project, UnsavedWorkIsKeptAndRecovered) {
    Driver driver;
    driver.open_beam();
    driver.workbench->autosave("/recovery.myoloop");
    EXPECT_TRUE(driver.backend->projects.empty()) << "nothing is unsaved";
    edit(driver);
    driver.workbench->autosave("/recovery.myoloop");
    driver.workbench->finish_autosave();
    ASSERT_EQ(driver.backend->projects.count("/recovery.myoloop"), 1u);

    Driver next;
    next.backend->projects = driver.backend->projects;
    next.workbench->execute(commands::OfferRecovery{{"/recovery.myoloop"}});
    next.settle();
    next.click("recovery/recover");
    ASSERT_TRUE(next.wait_for_job());
    ASSERT_TRUE(next.state().scene);
    EXPECT_EQ(next.state().settings, driver.state().settings);
    EXPECT_TRUE(next.state().unsaved());
    EXPECT_TRUE(next.state().project.empty());
}

TEST(Project, AutosaveDoesNotStopTheDrawing) {
    Driver driver;
    driver.open_beam();
    edit(driver);
    driver.backend->write_delay_s = 0.5;
    const auto start = std::chrono::steady_clock::now();
    driver.workbench->autosave("/recovery.myoloop");
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 0.2);
    driver.workbench->finish_autosave();
    EXPECT_EQ(driver.backend->projects.count("/recovery.myoloop"), 1u);
    // A failure is told once.
    driver.backend->write_delay_s = 0.0;
    for (int i = 0; i < 2; ++i) {
        edit(driver);
        driver.workbench->autosave("/forbidden/recovery.myoloop");
        driver.workbench->finish_autosave();
    }
    EXPECT_EQ(std::count_if(driver.state().log.begin(), driver.state().log.end(),
                            [](const commands::LogLine& line) { return line.level == commands::LogLevel::failure; }),
              1);
}

TEST(Recovery, IsAskedForBeforeTheFileOfTheCommandLineIsOpened) {
    Driver driver;
    driver.workbench->execute(commands::OfferRecovery{{"/older.myoloop", "/newer.myoloop"}});
    driver.window->open("/beam");
    driver.settle();
    EXPECT_FALSE(driver.state().busy());
    EXPECT_FALSE(driver.state().scene);
    driver.click("recovery/discard");
    EXPECT_EQ(driver.state().recovered, std::vector<std::filesystem::path>{"/older.myoloop"}) << "one after the other";
    EXPECT_FALSE(driver.state().scene);
    driver.click("recovery/discard");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_EQ(driver.state().scene->path, "/beam");
    EXPECT_FALSE(driver.has("recovery/discard"));
}

TEST(Recovery, TakesTheWorkUpInsteadOfTheFileOfTheCommandLine) {
    Driver before;
    before.open_beam();
    edit(before);
    before.workbench->autosave("/recovery.myoloop");
    before.workbench->finish_autosave();

    Driver driver;
    driver.backend->projects = before.backend->projects;
    driver.workbench->execute(commands::OfferRecovery{{"/recovery.myoloop"}});
    driver.window->open("/body.stl");
    driver.settle();
    EXPECT_FALSE(driver.state().unit_question);
    driver.click("recovery/recover");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_EQ(driver.state().settings, before.state().settings);
    EXPECT_FALSE(driver.state().unit_question);
    EXPECT_FALSE(driver.state().pending);
}

TEST(Project, KeepsColoursRangesAndTheCut) {
    Driver driver;
    driver.open_beam();
    commands::ViewOptions view = driver.state().view;
    view.color_map = "magma";
    view.field_ranges["height"] = {-0.01, 0.01};
    view.clip = {true, Eigen::Vector3d::UnitY(), 0.015, false};
    driver.workbench->execute(commands::ChangeView{view});
    driver.workbench->execute(commands::SaveAs{"/view.myoloop"});
    driver.workbench->execute(commands::ChangeView{commands::ViewOptions{}});
    driver.window->open("/view.myoloop");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().view, view);
}

TEST(StartPage, OpensExamplesAndWhatWasOpenLately) {
    Driver driver;
    driver.click("start/example/beam");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    ASSERT_EQ(driver.state().preferences.recent.size(), 1u);
    Driver next;
    next.workbench->execute(commands::UsePreferences{driver.state().preferences});
    next.settle();
    next.click("start/recent/0");
    ASSERT_TRUE(next.wait_for_job());
    EXPECT_TRUE(next.state().scene);
}

TEST(Menu, OpensAnotherExample) {
    Driver driver;
    driver.open_beam();
    const auto before = driver.state().scene;
    driver.click("menu/file");
    driver.click("menu/examples");
    driver.click("menu/example/beam");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_NE(driver.state().scene, before);
}

TEST(Menu, PerformsWhatItsEntriesSayAndKeysDoTheSame) {
    Driver driver;
    driver.open_beam();
    driver.click("menu/run");
    driver.click("menu/run.run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().run);
    driver.click("menu/view");
    driver.click("menu/view.theme");
    EXPECT_EQ(driver.state().preferences.theme, platform::ThemeName::light);
    driver.key(ui::platform::key_plus, {.ctrl = true, .shift = true});
    EXPECT_FLOAT_EQ(driver.state().scale(), 1.1f);
    driver.key(ui::platform::key_minus, {.ctrl = true});
    EXPECT_FLOAT_EQ(driver.state().scale(), 1.0f);
    driver.key(ui::platform::key_4);
    EXPECT_TRUE(driver.window->viewport().camera.orthographic);
}

TEST(Palette, FindsACommandByWordsInAnyOrder) {
    EXPECT_EQ(panels::matching_actions("save PROJECT as", panels::all_actions()).front()->id, "file.save_as");
    EXPECT_EQ(panels::matching_actions("run cal", panels::all_actions()).front()->id, "run.calibrate");
    EXPECT_TRUE(panels::matching_actions("no such thing", panels::all_actions()).empty());
    EXPECT_EQ(panels::matching_actions("", panels::all_actions()).size(), panels::all_actions().size());
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_k, {.ctrl = true});
    ASSERT_TRUE(driver.has("palette/text"));
    driver.type("tasks diagnose");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.window->task(), commands::Task::diagnose);
    EXPECT_FALSE(driver.has("palette/text"));
}

TEST(Palette, FindsExamplesTrialsPanelsQuantitiesAndLateFiles) {
    Driver driver;
    const auto ask = [&](const std::string& words) {
        driver.key(ui::platform::key_k, {.ctrl = true});
        driver.type(words);
        driver.key(ImGuiKey_Enter);
        driver.settle();
    };
    ask("example swinging");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    ask("trial pull_release");
    EXPECT_EQ(driver.state().trial, 1);
    ask("below messages");
    EXPECT_FALSE(driver.has("markers/marker")) << "another panel is in front";
    ask("colour height");
    EXPECT_TRUE(driver.state().view.field.empty()) << "without a run there is no height";
    driver.key(ImGuiKey_Escape);
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    ask("colour height");
    EXPECT_EQ(driver.state().view.field, "height");
    ask("colour none");
    EXPECT_TRUE(driver.state().view.field.empty());
    ask("recent beam");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().run) << "it was opened anew";
}

TEST(StartPage, NoRowHasACardAlone) {
    for (int cards = 1; cards <= 12; ++cards)
        for (int most = 1; most <= 4; ++most) {
            const int columns = panels::card_columns(cards, most);
            EXPECT_GE(columns, 1);
            EXPECT_LE(columns, std::max(1, most));
            EXPECT_TRUE(columns == 1 || cards % columns != 1) << cards << " cards, at most " << most;
        }
    EXPECT_EQ(panels::card_columns(4, 3), 2);
    EXPECT_EQ(panels::card_columns(5, 4), 3);
    Driver driver;
    const platform::Rectangle example = driver.item("start/example/beam"), open = driver.item("start/open");
    EXPECT_GT(open.lowest.y, example.highest.y);
    EXPECT_FLOAT_EQ(open.width(), example.width()) << "both fill their row";
}

TEST(Palette, ActionsHaveNamesAndKeysOfTheirOwn) {
    const auto& actions = panels::all_actions();
    for (std::size_t i = 0; i < actions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(actions[i].id, actions[j].id);
            const panels::Shortcut &a = actions[i].shortcut, &b = actions[j].shortcut;
            EXPECT_FALSE(a.key >= 0 && a.key == b.key && a.ctrl == b.ctrl && a.shift == b.shift)
                << actions[i].id << " and " << actions[j].id;
        }
}

TEST(About, NamesTheLibrariesInAWindowThatFits) {
    Driver driver(1400, 900);
    driver.workbench->execute(commands::SetTheme{platform::ThemeName::dark, 2.0f});
    driver.settle();
    driver.click("menu/help");
    driver.click("menu/help.about");
    ASSERT_TRUE(driver.has("about/close"));
    EXPECT_LT(driver.item("about/close").highest.y, 890.0f);
    EXPECT_GT(driver.item("about/text").lowest.y, 40.0f);
    driver.click("about/close");
    EXPECT_FALSE(driver.has("about/close"));
}

}  // namespace
}  // namespace myo::ui
