#include <gtest/gtest.h>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

/// A recording as it is chosen in the browser.
void read(Driver& driver, const std::string& file) {
    driver.workbench->execute(commands::ReadRecording{file});
    ASSERT_TRUE(driver.wait_for_job());
    driver.window->show_task(commands::Task::measure);
    driver.settle();
}

TEST(MarkerName, IsAKeyThatReadsAsTheLabel) {
    EXPECT_EQ(commands::marker_name("Tip - 1"), "Tip-1");
    EXPECT_EQ(commands::marker_name("upper tip:3"), "upper_tip_3");
    EXPECT_EQ(commands::marker_name("low_tip"), "low_tip");
}

TEST(Import, ReadsProposesAndAddsATrialThatIsThenShown) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop 3.c3d"));
    ASSERT_TRUE(driver.state().import);
    EXPECT_TRUE(driver.has("import/file") || driver.has("import/propose"));
    EXPECT_FALSE(driver.has("import/unit")) << "the file says its unit";
    EXPECT_EQ(driver.state().import->choices.trial, "drop_3");
    EXPECT_EQ(driver.state().import->choices.markers[2].name, "tip_top") << "proposed at once";
    EXPECT_DOUBLE_EQ(driver.state().import->choices.start_s, 0.3);
    // Time runs over the recording, whose start is t = 0.
    EXPECT_EQ(commands::time_span(driver.state())[0], -0.3);
    driver.click("import/align");
    EXPECT_DOUBLE_EQ(driver.state().import->choices.start_s, 0.31);
    driver.click("import/first_motion");
    EXPECT_DOUBLE_EQ(driver.state().import->choices.start_s, 0.3);
    driver.click("import/role/second");
    driver.click("import/add");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(driver.backend->added.size(), 1u);
    EXPECT_FALSE(driver.backend->added[0].fit);
    EXPECT_FALSE(driver.state().import);
    ASSERT_TRUE(driver.state().scene_trial());
    EXPECT_EQ(driver.state().scene_trial()->name, "drop_3");
    EXPECT_FALSE(driver.has("import/add"));
}

TEST(Import, MarkersAreChosenInTheTable) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    driver.click("import/marker/label 1");
    driver.click("import/marker/label 1/none");
    EXPECT_TRUE(driver.state().import->choices.markers[1].name.empty());
    // A marker belongs to one label.
    driver.click("import/marker/label 0");
    driver.click("import/marker/label 0/tip_top");
    EXPECT_EQ(driver.state().import->choices.markers[0].name, "tip_top");
    EXPECT_TRUE(driver.state().import->choices.markers[2].name.empty());
    driver.click("import/cancel");
    EXPECT_FALSE(driver.state().import);
    EXPECT_TRUE(driver.has("measure/import"));
}

TEST(Import, ChoicesAreUndoneOneByOne) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    const auto name_of = [&](std::size_t label) { return driver.state().import->choices.markers[label].name; };
    const std::string first = name_of(0), second = name_of(1);
    for (const char* label : {"0", "1"}) {
        driver.click(std::string("import/marker/label ") + label);
        driver.click(std::string("import/marker/label ") + label + "/none");
    }
    ASSERT_TRUE(name_of(0).empty() && name_of(1).empty());
    const commands::Settings settings = driver.state().settings;
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_EQ(name_of(1), second);
    EXPECT_TRUE(name_of(0).empty()) << "one marker at a time";
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_EQ(name_of(0), first);
    driver.key(ImGuiKey_Y, {.ctrl = true});
    EXPECT_TRUE(name_of(0).empty());
    EXPECT_EQ(driver.state().settings, settings);
}

TEST(Import, AClickOnADeclaredMarkerSaysThatTheLabelIsThisOne) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    const auto name_of = [&](std::size_t label) { return driver.state().import->choices.markers[label].name; };
    const auto place_of = [&](std::size_t marker) {
        return test::pixel_of(driver, driver.state().scene->markers[marker].rest_m);
    };
    driver.click("import/marker/label 1");
    driver.click("import/marker/label 1/none");
    driver.click("import/label/label 0");
    driver.click("import/place");
    ASSERT_TRUE(driver.has("view/placing_hint"));
    // Some pixels beside it are near enough; elsewhere on the body there is none.
    driver.click_at(test::pixel_of(driver, {0.03, 0.015, 0.03}));
    EXPECT_EQ(name_of(0), "tip_left") << "as proposed";
    const ImVec2 top = place_of(2);
    driver.click_at({top.x + 4.0f, top.y - 3.0f});
    EXPECT_EQ(name_of(0), "tip_top");
    EXPECT_FALSE(driver.state().import->choices.markers[0].rest_m) << "where it sits is declared";
    EXPECT_TRUE(name_of(2).empty()) << "a marker belongs to one label";
    EXPECT_EQ(driver.state().import->label, 1) << "the next that is none yet";
    driver.click_at(place_of(0));
    EXPECT_EQ(name_of(1), "tip_left");
    driver.key(ImGuiKey_Escape);
    driver.settle();
    EXPECT_FALSE(driver.state().import->placing);
    driver.click("import/add");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(driver.backend->added.size(), 1u);
    EXPECT_EQ(driver.backend->added[0].markers[0].name, "tip_top");
    EXPECT_EQ(driver.backend->added[0].markers[1].name, "tip_left");
}

TEST(Import, AClickOnAPlainMeshPlacesANewMarker) {
    Driver driver;
    driver.workbench->execute(commands::Open{"/body.stl", 1e-3});
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    driver.click("import/place");
    ASSERT_TRUE(driver.has("view/placing_hint"));
    const Eigen::Vector3d middle(0.05, 0.015, 0.03);
    driver.click_at(test::pixel_of(driver, middle));
    ASSERT_TRUE(driver.state().import->choices.markers[0].rest_m);
    EXPECT_LT((*driver.state().import->choices.markers[0].rest_m - middle).norm(), 2e-3);
    EXPECT_EQ(driver.state().import->choices.markers[0].name, "label_0");
    EXPECT_EQ(driver.state().import->label, 1) << "the next one";
}

TEST(Import, TheStartIsDraggedInThePlotOverTheGapMap) {
    Driver driver(1600, 900);
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    driver.window->show_panel("recording");
    driver.settle();
    const platform::Rectangle plot = driver.item("recording/x");
    const double before = driver.state().import->choices.start_s;
    driver.click_at({plot.lowest.x + 0.8f * plot.width(), plot.center().y});
    driver.settle();
    EXPECT_GT(driver.state().import->choices.start_s, before + 0.4);
    // Rows of the map choose the label.
    driver.click("recording/seen/label 2");
    EXPECT_EQ(driver.state().import->label, 2);
    // Where a marker was hidden its row shows it.
    const platform::Image picture = driver.picture();
    const platform::Rectangle seen = driver.item("recording/seen/label 0"),
                              hidden = driver.item("recording/seen/label 1");
    const ImVec4 orange = platform::make_theme(platform::ThemeName::dark, 1.0f).measured;
    const auto orange_columns = [&](const platform::Rectangle& row) {
        int count = 0;
        for (float x = row.lowest.x; x < row.highest.x; x += 1.0f)
            count += test::color_near(picture, {x, row.center().y}, orange, 0) ? 1 : 0;
        return count;
    };
    EXPECT_NEAR(static_cast<double>(orange_columns(hidden)) / orange_columns(seen), 0.8, 0.05);
}

TEST(Import, AsksOnlyForWhatTheFileDoesNotSay) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/stream.txt"));
    driver.click("import/unit");
    driver.click("import/unit/m");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().import->file.reading.metres_per_unit, 1.0);
    EXPECT_EQ(driver.state().import->choices.markers[2].name, "tip_top") << "what was chosen is kept";
}

TEST(Import, FailuresAreToldAndNothingIsLost) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(commands::ReadRecording{"/takes/missing"});
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
    EXPECT_FALSE(driver.state().import);
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/taken.c3d"));
    driver.click("import/add");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
    ASSERT_TRUE(driver.state().import) << "to choose another name";
}

TEST(Import, WhatWasSetOnTheBodyStays) {
    Driver driver;
    driver.open_beam();
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa = 3.3e5;
    driver.workbench->execute(commands::ChangeSettings{settings, "E", false});
    ASSERT_NO_FATAL_FAILURE(read(driver, "/takes/drop.c3d"));
    driver.click("import/add");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 3.3e5);
    EXPECT_TRUE(driver.state().unsaved());
}

}  // namespace
}  // namespace myo::ui
