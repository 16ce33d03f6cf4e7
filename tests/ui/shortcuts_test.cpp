#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "ui/driver.hpp"

// What each key does, and when it does nothing.

namespace myo::ui::shortcuts {
namespace {

using platform::Modifiers;
using test::Driver;

constexpr Modifiers plain{}, ctrl{true, false, false}, ctrl_shift{true, true, false}, shift{false, true, false};

/// Changes the density, as an edit to undo.
void edit_density(Driver& driver, double density_kg_m3) {
    commands::Settings settings = driver.state().settings;
    settings.density_kg_m3 = density_kg_m3;
    driver.workbench->execute(commands::ChangeSettings{settings, "density", false});
    driver.settle();
}

TEST(Shortcuts, OfJobsBeginThemAndWithoutCtrlDoNot) {
    Driver driver;
    for (const int key : {platform::key_m, platform::key_r, platform::key_d}) {
        driver.key(key, ctrl);
        EXPECT_FALSE(driver.state().busy()) << "nothing is open";
    }
    driver.open_beam();
    struct Job {
        int key;
        const char* name;
    };
    for (const Job& job : {Job{platform::key_m, "Mesh"}, Job{platform::key_r, "Simulate"},
                           Job{platform::key_d, commands::diagnose_job}}) {
        const std::size_t before = driver.state().history.size();
        for (const Modifiers& wrong : {plain, shift, ctrl_shift}) driver.key(job.key, wrong);
        ASSERT_TRUE(driver.wait_for_job());
        ASSERT_EQ(driver.state().history.size(), before) << job.name;
        driver.key(job.key, ctrl);
        ASSERT_TRUE(driver.wait_for_job());
        ASSERT_EQ(driver.state().history.size(), before + 1) << job.name;
        EXPECT_EQ(driver.state().history.back().name, job.name);
    }
    driver.key(platform::key_p, ctrl);
    EXPECT_TRUE(driver.state().preview.on);
    driver.key(platform::key_p, ctrl);
    EXPECT_FALSE(driver.state().preview.on);
}

TEST(Shortcuts, OfUndoTakeOneStepEach) {
    Driver driver;
    driver.open_beam();
    driver.key(ImGuiKey_Z, ctrl);
    EXPECT_EQ(driver.state().settings, driver.state().saved_settings) << "there is nothing to undo";
    const double first = driver.state().settings.density_kg_m3;
    edit_density(driver, 1100.0);
    edit_density(driver, 1200.0);
    const auto density = [&](int key, const Modifiers& modifiers) {
        driver.key(key, modifiers);
        return driver.state().settings.density_kg_m3;
    };
    EXPECT_EQ(density(ImGuiKey_Z, plain), 1200.0);
    EXPECT_EQ(density(ImGuiKey_Z, ctrl), 1100.0);
    EXPECT_EQ(density(ImGuiKey_Y, plain), 1100.0);
    EXPECT_EQ(density(ImGuiKey_Z, ctrl), first);
    EXPECT_EQ(density(ImGuiKey_Z, ctrl), first) << "the first one";
    EXPECT_EQ(density(ImGuiKey_Y, ctrl), 1100.0);
    EXPECT_EQ(density(ImGuiKey_Z, ctrl_shift), 1200.0) << "the other key for it, which must not undo as well";
    EXPECT_EQ(density(ImGuiKey_Y, ctrl), 1200.0) << "the last one";
}

TEST(Shortcuts, OfTheViewTurnItAndLeaveTheModel) {
    Driver driver;
    driver.open_beam();
    const commands::Settings before = driver.state().settings;
    const auto back = [&](int key) {
        driver.key(key);
        return viewport::camera_axes(driver.window->viewport().camera).back;
    };
    EXPECT_LT((back(platform::key_1) - Eigen::Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_LT((back(platform::key_1) + Eigen::Vector3d::UnitX()).norm(), 1e-9) << "the same again: from behind";
    EXPECT_LT((back(platform::key_2) + Eigen::Vector3d::UnitY()).norm(), 1e-9);
    EXPECT_LT((back(platform::key_3) - Eigen::Vector3d::UnitZ()).norm(), 2e-3);
    const Eigen::Vector3d oblique = back(platform::key_0);
    EXPECT_GT(oblique.cwiseAbs().minCoeff(), 0.2) << "along none of the axes";
    driver.key(platform::key_4);
    EXPECT_TRUE(driver.window->viewport().camera.orthographic);
    driver.key(platform::key_4);
    EXPECT_FALSE(driver.window->viewport().camera.orthographic);
    // Far away, and back to the whole body.
    const double distance = driver.window->viewport().camera.distance;
    const ImVec2 middle = driver.item("view").center();
    driver.wheel(middle, -4.0f);
    EXPECT_GT(driver.window->viewport().camera.distance, 1.2 * distance);
    driver.key(platform::key_f);
    EXPECT_NEAR(driver.window->viewport().camera.distance, distance, 1e-6 * distance);
    EXPECT_EQ(driver.state().settings, before);
    EXPECT_FALSE(driver.state().can_undo);
}

TEST(Shortcuts, OfToolsNeedTheirMuscleAndExcludeEachOther) {
    Driver driver;
    driver.open_beam();
    using commands::BrushTool;
    const auto tool = [&](int key, const Modifiers& modifiers = plain) {
        driver.key(key, modifiers);
        return driver.state().brush.tool;
    };
    EXPECT_EQ(tool(platform::key_b), BrushTool::none) << "there is no muscle";
    commands::Settings settings = driver.state().settings;
    settings.muscles.resize(1);
    settings.muscles[0].name = "left";
    driver.workbench->execute(commands::ChangeSettings{settings, "muscle", false});
    EXPECT_EQ(tool(platform::key_b, ctrl), BrushTool::none);
    EXPECT_EQ(tool(platform::key_b), BrushTool::add);
    EXPECT_EQ(driver.window->task(), commands::Task::fibres) << "where the brush is set";
    EXPECT_EQ(tool(platform::key_e), BrushTool::erase);
    EXPECT_EQ(tool(platform::key_e), BrushTool::none) << "pressed again it is put away";
    EXPECT_EQ(tool(platform::key_b), BrushTool::add);
    EXPECT_EQ(tool(platform::key_d), BrushTool::none) << "clicks measure now";
    EXPECT_TRUE(driver.window->viewport().measuring);
    driver.key(platform::key_d);
    EXPECT_FALSE(driver.window->viewport().measuring);
}

TEST(Shortcuts, OfFilesAndOfTheWindow) {
    Driver driver;
    // A first Escape may only leave the field for the name.
    const auto close_browser = [&] {
        for (int i = 0; i < 3 && driver.has("browser/cancel"); ++i) driver.key(ImGuiKey_Escape);
        EXPECT_FALSE(driver.has("browser/cancel"));
    };
    driver.key(platform::key_s, ctrl);
    EXPECT_FALSE(driver.state().asks_where_to_save) << "nothing is open";
    driver.key(ImGuiKey_Space);
    EXPECT_FALSE(driver.state().playing);
    driver.open_beam();
    driver.key(platform::key_s, ctrl);
    EXPECT_TRUE(driver.state().asks_where_to_save) << "it has no name yet";
    // The keys belong to the dialog until it is closed.
    driver.key(platform::key_r, ctrl);
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().history.empty());
    close_browser();
    EXPECT_FALSE(driver.state().asks_where_to_save);
    driver.key(platform::key_s, ctrl_shift);
    EXPECT_TRUE(driver.state().asks_where_to_save);
    close_browser();
    driver.key(platform::key_o, ctrl);
    EXPECT_TRUE(driver.has("browser/cancel"));
    close_browser();
    driver.key(platform::key_q);
    EXPECT_FALSE(driver.state().quit);
    driver.key(platform::key_q, ctrl);
    EXPECT_TRUE(driver.state().quit);
    EXPECT_FALSE(driver.has("help/close"));
    driver.key(platform::key_f1);
    EXPECT_TRUE(driver.has("help/close"));
}

TEST(Shortcuts, BelongToTheFieldThatIsTypedInto) {
    Driver driver;
    driver.open_beam();
    edit_density(driver, 1100.0);
    driver.double_click("model/youngs_modulus");
    driver.key(platform::key_r, ctrl);
    driver.key(ImGuiKey_Z, ctrl);
    driver.key(platform::key_4);
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().history.empty());
    EXPECT_EQ(driver.state().settings.density_kg_m3, 1100.0) << "the text is undone, not the edit before it";
    EXPECT_FALSE(driver.window->viewport().camera.orthographic);
    driver.key(ImGuiKey_Escape);
    driver.key(ImGuiKey_Z, ctrl);
    EXPECT_EQ(driver.state().settings.density_kg_m3, 1070.0);
}

}  // namespace
}  // namespace myo::ui::shortcuts
