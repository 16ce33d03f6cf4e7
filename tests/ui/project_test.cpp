#include <gtest/gtest.h>

#include "panels/palette.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

void edit(Driver& driver) {
    Settings settings = driver.state().settings;
    settings.density_kg_m3 += 30.0;
    driver.workbench->execute(command::ChangeSettings{settings, "test", false});
    driver.settle();
}

TEST(Project, IsSavedUnderANameAndOpenedAgain) {
    Driver driver;
    driver.open_beam();
    EXPECT_FALSE(driver.state().unsaved());
    edit(driver);
    driver.workbench->execute(command::ChooseTrial{1});
    EXPECT_TRUE(driver.state().unsaved());
    driver.key(key_s, {.ctrl = true});
    ASSERT_TRUE(driver.has("browser/name")) << "a project that has no file yet asks for one";
    driver.click("browser/open");
    ASSERT_EQ(driver.backend->projects.size(), 1u);
    const auto file = driver.state().project;
    EXPECT_EQ(file.extension(), project_ending);
    EXPECT_FALSE(driver.state().unsaved());
    const Settings saved = driver.state().settings;
    edit(driver);
    driver.key(key_s, {.ctrl = true});
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
    driver.key(key_q, {.ctrl = true});
    ASSERT_TRUE(driver.has("unsaved/save"));
    driver.click("unsaved/save");
    ASSERT_TRUE(driver.has("browser/open"));
    EXPECT_FALSE(driver.state().quit);
    driver.click("browser/cancel");
    EXPECT_FALSE(driver.state().quit) << "who gives up saving has not left";
    driver.key(key_q, {.ctrl = true});
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
    driver.workbench->execute(command::SaveAs{"/forbidden/x.myoloop"});
    EXPECT_EQ(driver.state().log.back().level, LogLevel::failure);
    EXPECT_TRUE(driver.state().unsaved());
}

TEST(Project, UnsavedWorkIsKeptAndRecovered) {
    Driver driver;
    driver.open_beam();
    driver.workbench->autosave("/recovery.myoloop");
    EXPECT_TRUE(driver.backend->projects.empty()) << "nothing is unsaved";
    edit(driver);
    driver.workbench->autosave("/recovery.myoloop");
    ASSERT_EQ(driver.backend->projects.count("/recovery.myoloop"), 1u);

    Driver next;
    next.backend->projects = driver.backend->projects;
    next.workbench->execute(command::OfferRecovery{{"/recovery.myoloop"}});
    next.settle();
    next.click("recovery/recover");
    ASSERT_TRUE(next.wait_for_job());
    ASSERT_TRUE(next.state().scene);
    EXPECT_EQ(next.state().settings, driver.state().settings);
    EXPECT_TRUE(next.state().unsaved());
    EXPECT_TRUE(next.state().project.empty());
}

TEST(StartPage, OpensExamplesAndWhatWasOpenLately) {
    Driver driver;
    driver.click("start/example/beam");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    ASSERT_EQ(driver.state().preferences.recent.size(), 1u);
    Driver next;
    next.workbench->execute(command::UsePreferences{driver.state().preferences});
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
    EXPECT_EQ(driver.state().preferences.theme, ThemeName::light);
    driver.key(key_plus, {.ctrl = true, .shift = true});
    EXPECT_FLOAT_EQ(driver.state().scale(), 1.25f);
    driver.key(key_minus, {.ctrl = true});
    EXPECT_FLOAT_EQ(driver.state().scale(), 1.0f);
    driver.key(key_4);
    EXPECT_TRUE(driver.window->viewport().camera.orthographic);
}

TEST(Palette, FindsACommandByWordsInAnyOrder) {
    EXPECT_EQ(matching_actions("save PROJECT as").front()->id, "file.save_as");
    EXPECT_EQ(matching_actions("run cal").front()->id, "run.calibrate");
    EXPECT_TRUE(matching_actions("no such thing").empty());
    EXPECT_EQ(matching_actions("").size(), all_actions().size());
    Driver driver;
    driver.open_beam();
    driver.key(key_k, {.ctrl = true});
    ASSERT_TRUE(driver.has("palette/text"));
    driver.type("step diagnose");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.window->step(), Step::diagnose);
    EXPECT_FALSE(driver.has("palette/text"));
}

TEST(Palette, ActionsHaveNamesAndKeysOfTheirOwn) {
    const auto& actions = all_actions();
    for (std::size_t i = 0; i < actions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(actions[i].id, actions[j].id);
            const Shortcut &a = actions[i].shortcut, &b = actions[j].shortcut;
            EXPECT_FALSE(a.key >= 0 && a.key == b.key && a.ctrl == b.ctrl && a.shift == b.shift) << actions[i].id << " and " << actions[j].id;
        }
}

TEST(About, NamesTheLibraries) {
    Driver driver;
    driver.click("menu/help");
    driver.click("menu/help.about");
    ASSERT_TRUE(driver.has("about/close"));
    driver.click("about/close");
    EXPECT_FALSE(driver.has("about/close"));
}

}  // namespace
}  // namespace myo
