#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/driver.hpp"

// The popup of the marker plots that repairs a recording.

namespace myo::ui {
namespace {

using test::Driver;
using testing::HasSubstr;

/// The beam as an experiment, with its repairs open.
struct OpenedRepairs {
    Driver driver{1280, 1000};

    OpenedRepairs() {
        driver.backend->as_experiment = true;
        driver.open_beam();
        driver.window->show_panel("markers");
        driver.settle();
        driver.click("repair/open");
    }
    void type(const std::string& item, const std::string& text) {
        driver.double_click(item);
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
        driver.key(ImGuiKey_Enter);
    }
    /// Lines of the last repair that was asked for; empty if the last edit is none.
    std::string last() const {
        if (driver.backend->edits.empty()) return "";
        const auto* const added = std::get_if<commands::AppendDeclared>(&driver.backend->edits.back());
        const toml::TomlPath repairs{"trial", std::size_t{0}, "repair"};
        return added && added->array == repairs ? added->body : "";
    }
};

TEST(RepairPopup, NeedsASpanAndWritesTimesOfTheRecording) {
    OpenedRepairs opened;
    opened.driver.click("repair/cut");
    EXPECT_TRUE(opened.driver.backend->edits.empty()) << "no time is selected";
    opened.type("repair/from", "0.501");
    opened.type("repair/to", "0.7");
    opened.driver.click("repair/cut");
    // The recording begins 1.5 s before the trial; samples are 10 ms apart.
    EXPECT_EQ(opened.last(), "kind = \"cut\"\nmarker = \"tip_left\"\nfrom_s = 2.01\nto_s = 2.2\n");
    EXPECT_EQ(opened.driver.backend->edits.size(), 1u);
}

TEST(RepairPopup, KeepsTheSpanForTheNextRepair) {
    OpenedRepairs opened;
    opened.type("repair/from", "0.5");
    opened.type("repair/to", "0.7");
    opened.driver.click("repair/cut");
    opened.driver.click("repair/fill");
    EXPECT_THAT(opened.last(), HasSubstr("kind = \"fill\""));
    EXPECT_THAT(opened.last(), HasSubstr("from_s = 2.0\nto_s = 2.2\n"));
}

TEST(RepairPopup, SwapsWithTheChosenMarkerAndSmoothsInTheStatedWindow) {
    OpenedRepairs opened;
    opened.type("repair/from", "0.5");
    opened.type("repair/to", "0.7");
    opened.driver.click("repair/with");
    opened.driver.click("repair/with/2");
    opened.driver.click("repair/swap");
    EXPECT_THAT(opened.last(), HasSubstr("kind = \"swap\"\nmarker = \"tip_left\"\nwith = \"tip_top\"\n"));
    opened.type("repair/window", "80 ms");
    opened.driver.click("repair/smooth");
    EXPECT_THAT(opened.last(), HasSubstr("kind = \"smooth\"\nmarker = \"tip_left\"\nwindow_s = 0.08\n"));
}

TEST(RepairPopup, TakesTheTimeThatIsSelectedInAPlot) {
    Driver driver{1280, 1000};
    driver.backend->as_experiment = true;
    driver.open_beam();
    driver.window->show_panel("markers");
    driver.settle();
    const platform::Rectangle plot = driver.item("plot/x");
    const float y = plot.center().y;
    driver.drag({plot.lowest.x + 0.3f * plot.width(), y}, {plot.lowest.x + 0.6f * plot.width(), y}, 0, {.shift = true});
    ASSERT_TRUE(driver.has("plot/x/chosen"));
    driver.click("repair/open");
    driver.click("repair/cut");
    ASSERT_EQ(driver.backend->edits.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<commands::AppendDeclared>(driver.backend->edits[0]));
    EXPECT_TRUE(driver.has("plot/x/chosen")) << "the selection stays after the edit";
}

TEST(RepairPopup, IsNotOfferedWithoutARecording) {
    Driver driver{1280, 1000};
    driver.open_beam();
    driver.window->show_panel("markers");
    driver.settle();
    driver.click("repair/open");
    EXPECT_FALSE(driver.has("repair/cut"));
}

}  // namespace
}  // namespace myo::ui
