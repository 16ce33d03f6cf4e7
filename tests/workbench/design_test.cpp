#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "backend/workbench_backend.hpp"
#include "support/experiment_folder.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/arm.hpp"
#include "workbench/example_copy.hpp"

// Optimise changes the body: ticks in the window, a result that is one edit.

namespace myo {
namespace {

using test::Driver;
using testing::HasSubstr;

/// The arm with its muscle contracted, a further part, and a goal beside where the tip goes.
std::string bent_arm_toml() {
    const std::string
        part = "[[part]]\nname = \"end\"\nbox_m = [[0.04, 0.0, 0.0], [0.08, 0.02, 0.02]]\nyoungs_modulus_Pa = 2.0e5\n";
    return testing_support::replaced(test::arm_toml, "[[muscle]]\n", part + "[[muscle]]\n") +
           "activation = { upper = 0.9 }\n[[trial.goal]]\nmarker = \"tip\"\ntime_s = 0.2\nplace_m = [0.08, 0.012, "
           "0.021]\naxes = [\"y\", \"z\"]\n";
}

TEST(DesignInWindow, DirectionAndModulusAreTickedFoundAndUndone) {
    const test::Folder folder("design_in_window");
    folder.write("arm/experiment.toml", bent_arm_toml());
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(folder.path() / "arm");
    ASSERT_TRUE(driver.wait_for_job(60)) << driver.state().log.back().text;
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.01;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
    driver.window->show_panel("fit");
    driver.settle();
    driver.click("fit/seek");
    ASSERT_TRUE(driver.has("fit/seek/direction:upper"));
    EXPECT_FALSE(driver.has("fit/seek/weights:upper")) << "the muscle is a box, not painted";
    ASSERT_TRUE(driver.has("fit/frequency"));
    driver.click("fit/seek/signals");
    driver.key(ImGuiKey_Escape);
    driver.settle();
    EXPECT_FALSE(driver.has("fit/frequency")) << "numbers of signals that are not sought";
    driver.click("fit/optimize");
    EXPECT_THAT(driver.state().log.back().text, HasSubstr("tick what the search may change"));
    driver.click("fit/seek");
    driver.click("fit/seek/direction:upper");
    driver.click("fit/seek/modulus:end");
    driver.key(ImGuiKey_Escape);
    const ui::commands::Settings before = driver.state().settings;
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job(240));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    const ui::commands::SearchResult& found = *driver.state().found;
    EXPECT_LT(found.rms_after_m, 0.3 * found.rms_before_m);
    ASSERT_EQ(found.parameters.size(), 2u);
    EXPECT_EQ(found.parameters[0].unit, "°");
    EXPECT_EQ(found.parameters[1].name, "Young's modulus of end");
    EXPECT_EQ(found.parameters[1].start, 200.0);
    // Both stand in the declaration now, and are gone with one step back.
    ASSERT_TRUE(driver.state().settings.declaration.text);
    EXPECT_EQ(driver.state().settings.declaration.text->find("fibre = [1.0, 0.0, 0.0]"), std::string::npos);
    ASSERT_EQ(driver.state().scene->parts.size(), 1u);
    EXPECT_NEAR(driver.state().scene->parts[0].youngs_modulus_Pa, 1e3 * found.parameters[1].value, 1.0);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().settings, before);
    EXPECT_EQ(driver.state().scene->parts[0].youngs_modulus_Pa, 2e5);
}

/// A painted muscle has weights to be sought; the paint that is found replaces the one of before.
TEST(DesignInWindow, PaintIsFoundAndUndone) {
    const test::Folder folder("paint_in_window");
    folder.write("arm/experiment.toml", bent_arm_toml());
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(folder.path() / "arm");
    ASSERT_TRUE(driver.wait_for_job(60)) << driver.state().log.back().text;
    ui::commands::Settings painted = driver.state().settings;
    painted.resolution_m = 0.01;
    driver.workbench->execute(ui::commands::ChangeSettings{painted, "resolution"});
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    const ui::commands::MeshedBody& body = *driver.state().body;
    painted.muscles[0].paint = std::make_shared<const fibre::PaintedMask>(
        fibre::mask_of_cells(body.mesh, body.muscles.at("upper")));
    driver.workbench->execute(ui::commands::ChangeSettings{painted, "paint"});
    driver.window->show_panel("fit");
    driver.settle();
    driver.click("fit/seek");
    driver.click("fit/seek/signals");
    driver.click("fit/seek/weights:upper");
    driver.click("fit/seek/direction:upper");
    driver.key(ImGuiKey_Escape);
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job(240));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    EXPECT_LT(driver.state().found->rms_after_m, 0.5 * driver.state().found->rms_before_m);
    EXPECT_NE(driver.state().settings.muscles[0].paint, painted.muscles[0].paint);
    EXPECT_NE(driver.state().settings.muscles[0].paint->weights, painted.muscles[0].paint->weights);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().settings.muscles[0].paint, painted.muscles[0].paint);
}

/// A signal without its tick is not sought; ticks stand in the declaration, so that project, folder and undo have them.
TEST(DesignInWindow, ATendonWithoutItsTickKeepsItsTension) {
    const test::Folder folder("kept_tendon");
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(test::example_copy(folder, "tendon_tentacle"));
    ASSERT_TRUE(driver.wait_for_job(60)) << driver.state().log.back().text;
    driver.workbench->execute(ui::commands::ChooseTrial{2});
    ui::commands::OptimizeRequest request = driver.state().optimize;
    request.max_evaluations = 2;
    driver.workbench->execute(ui::commands::ChangeOptimize{request});
    const auto tension = [&](const char* name) {
        return driver.state().scene_trial()->commands.at(name).signal.value(0.0);
    };
    const double left = tension("left"), right = tension("right");
    driver.window->show_panel("fit");
    driver.settle();
    driver.click("fit/seek");
    driver.click("fit/seek/signal/left");
    driver.key(ImGuiKey_Escape);
    ASSERT_EQ(driver.state().scene->declared.kept, std::set<std::string>{"left"}) << driver.state().refused;
    EXPECT_THAT(*driver.state().settings.declaration.text, HasSubstr("sought = false"));
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job(240));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    EXPECT_EQ(tension("left"), left);
    EXPECT_NE(tension("right"), right);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(tension("right"), right);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->declared.kept.empty());
    EXPECT_FALSE(driver.state().can_undo);
}

/// A body with a chamber and no muscle: the pressure that is found stands in the trial as a curve.
TEST(DesignInWindow, APressureIsFoundWithoutAnyMuscle) {
    const test::Folder folder("pressure_in_window");
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(test::example_copy(folder, "pneumatic_finger"));
    ASSERT_TRUE(driver.wait_for_job(60)) << driver.state().log.back().text;
    ui::commands::OptimizeRequest request = driver.state().optimize;
    request.max_evaluations = 3;
    request.frequency_Hz = 5.0;
    driver.workbench->execute(ui::commands::ChangeOptimize{request});
    const ui::commands::Settings before = driver.state().settings;
    const auto pressure = [&] { return driver.state().scene_trial()->commands.at("chamber").signal; };
    ASSERT_EQ(pressure().value(0.1), 25000.0);
    driver.window->show_panel("fit");
    driver.settle();
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job(240));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    EXPECT_LE(driver.state().found->rms_after_m, driver.state().found->rms_before_m);
    ASSERT_TRUE(driver.state().settings.declaration.text) << driver.state().found->notes.back();
    EXPECT_THAT(*driver.state().settings.declaration.text, HasSubstr("chamber = [["));
    EXPECT_GT(pressure().times_s.size(), 2u);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().settings, before);
    EXPECT_EQ(pressure().value(0.1), 25000.0);
}

}  // namespace
}  // namespace myo
