#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

/// Where the tooltip is that is shown now.
std::optional<platform::Rectangle> tooltip_shown() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if ((window->Flags & ImGuiWindowFlags_Tooltip) && window->WasActive && !window->Hidden)
            return platform::Rectangle{window->Pos, {window->Pos.x + window->Size.x, window->Pos.y + window->Size.y}};
    return std::nullopt;
}

/// Puts the mouse on an item and checks that it is explained within the window.
void expect_explained(Driver& driver, const std::string& name) {
    const ImVec2 at = driver.item(name).center();
    driver.window->input().push(platform::MouseMoved{at.x, at.y});
    driver.settle();
    const auto tip = tooltip_shown();
    ASSERT_TRUE(tip) << name << " has no tooltip";
    EXPECT_GE(tip->lowest.x, 0.0f) << name;
    EXPECT_GE(tip->lowest.y, 0.0f) << name;
    EXPECT_LE(tip->highest.x, static_cast<float>(driver.width)) << name;
    EXPECT_LE(tip->highest.y, static_cast<float>(driver.height)) << name;
}

TEST(Tooltips, EveryParameterHasOneThatFitsLargeLetters) {
    Driver driver(1400, 900);
    driver.open_beam();
    driver.workbench->execute(commands::SetTheme{platform::ThemeName::dark, 2.0f});
    driver.settle();
    driver.window->show_task(commands::Task::mesh);
    driver.settle();
    for (const char* name : {"body/element", "body/edge_length"}) expect_explained(driver, name);
    driver.window->show_task(commands::Task::material);
    driver.settle();
    for (const char* name :
         {"model/material", "model/youngs_modulus", "model/poissons_ratio", "model/density", "model/damping"})
        expect_explained(driver, name);
    commands::Settings settings = driver.state().settings;
    settings.integrator = "generalized_alpha";
    driver.workbench->execute(commands::ChangeSettings{settings, "scheme", false});
    driver.window->show_task(commands::Task::run);
    driver.settle();
    for (const char* name : {"model/integrator", "model/spectral_radius", "model/time_step", "model/velocity_force"})
        expect_explained(driver, name);
}

/// A person who types into a field looks at the next one already.
TEST(Tooltips, LeaveTheOtherFieldsFree) {
    Driver driver(1400, 900);
    driver.open_beam();
    driver.window->show_task(commands::Task::material);
    driver.settle();
    expect_explained(driver, "model/youngs_modulus");
    const auto tip = tooltip_shown();
    ASSERT_TRUE(tip);
    for (const char* name : {"model/youngs_modulus", "model/poissons_ratio", "model/density", "model/damping"})
        EXPECT_GE(tip->lowest.x, driver.item(name).highest.x) << name;
}

TEST(Tooltips, BrushAndSignalsAreExplained) {
    Driver driver(1400, 900);
    driver.open_beam();
    driver.click("fibres/add");
    driver.click("fibres/tool/paint");
    for (const char* name :
         {"fibres/stiffness", "fibres/radius", "fibres/depth", "fibres/falloff", "fibres/strength", "fibres/direction"})
        expect_explained(driver, name);
    driver.window->show_panel("signals");
    driver.settle();
    for (const char* name : {"signals/file", "signals/fit"}) expect_explained(driver, name);
    driver.click("signals/generate");
    driver.click("signals/shape");
    driver.click("signals/shape/sine");
    for (const char* name : {"signals/level", "signals/start", "signals/frequency", "signals/end"})
        expect_explained(driver, name);
}

TEST(Tooltips, CurvesOfASearchAndNumbersOfAVerdictAreExplained) {
    Driver driver(1400, 900);
    driver.open_beam();
    driver.click("fit/calibrate");
    ASSERT_TRUE(driver.wait_for_job());
    driver.window->show_panel("search");
    driver.settle();
    for (const char* name : {"search/rms/title", "search/loss/title", "search/gradient/title"})
        expect_explained(driver, name);
    driver.window->show_panel("diagnose");
    driver.settle();
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(driver.wait_for_job());
    driver.window->show_task(commands::Task::diagnose);
    driver.settle();
    for (const char* name : {"verdict/confidence", "verdict/noise"}) expect_explained(driver, name);
}

}  // namespace
}  // namespace myo::ui
