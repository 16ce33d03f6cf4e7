#include <gtest/gtest.h>

#include <map>

#include "commands/settings_difference.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(MaterialPanel, SetsTheNumbersOfALaw) {
    Driver driver;
    driver.open_beam();
    EXPECT_FALSE(driver.has("model/gent_limit"));
    driver.click("model/material");
    driver.click("model/material/gent");
    ASSERT_TRUE(driver.has("model/gent_limit"));
    const commands::Settings usual = driver.state().settings;
    const auto set_limit = [&](const std::string& text) {
        driver.double_click("model/gent_limit");
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
        driver.key(ImGuiKey_Enter);
    };
    set_limit("12.5");
    EXPECT_EQ(driver.state().settings.law, (std::map<std::string, double>{{"gent_limit", 12.5}}));
    const std::vector<commands::SettingDifference> rows = commands::settings_differences(
        {&usual, &driver.state().settings}, driver.state().materials, driver.state().integrators);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].name, "Limit J");
    EXPECT_EQ(rows[0].values, (std::vector<std::string>{"30", "12.5"}));
    set_limit("0");
    EXPECT_EQ(driver.state().settings.law.at("gent_limit"), 12.5) << "values outside are refused";
    EXPECT_TRUE(driver.has("model/gent_limit: 0 is below the lowest Limit J, 0.1"));
    driver.key(ImGuiKey_Escape);
    EXPECT_EQ(driver.state().settings.law.at("gent_limit"), 12.5);
    // The number is kept for when the law is chosen again.
    driver.click("model/material");
    driver.click("model/material/corotational");
    EXPECT_FALSE(driver.has("model/gent_limit"));
    EXPECT_EQ(driver.state().settings.law.at("gent_limit"), 12.5);
}

}  // namespace
}  // namespace myo::ui
