#include <gtest/gtest.h>

#include <imgui.h>

#include "commands/settings_difference.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(SummaryPanel, ShowsAndCopiesTheWholeModel) {
    Driver driver(1600, 900);
    EXPECT_FALSE(driver.has("panel/summary")) << "there is no model yet";
    driver.open_beam();
    driver.click("panel/summary");
    for (const char* row : {"summary/Name", "summary/Mesh", "summary/Material", "summary/Young's modulus E"})
        EXPECT_TRUE(driver.has(row)) << row;
    driver.click("summary/copy");
    const std::string text = ImGui::GetClipboardText();
    EXPECT_NE(text.find("Young's modulus E\t260 kPa\n"), std::string::npos) << text;
    EXPECT_NE(text.find("Trial "), std::string::npos) << text;
}

TEST(SummaryPanel, RowsAreThoseThatApply) {
    Driver driver;
    driver.open_beam();
    const auto has = [&](const std::string& name) {
        for (const commands::SettingDifference& row :
             commands::settings_rows(driver.state().settings, driver.state().materials, driver.state().integrators))
            if (row.name == name) return true;
        return false;
    };
    EXPECT_TRUE(has("Time step h"));
    EXPECT_FALSE(has("Limit J")) << "of another law";
    driver.click("model/material");
    driver.click("model/material/gent");
    EXPECT_TRUE(has("Limit J"));
}

}  // namespace
}  // namespace myo::ui
