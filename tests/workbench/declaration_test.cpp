#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "commands/workflow.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/opened_beam.hpp"

// The declaration of an experiment is edited in the window: support, gravity, trials, loads, unknown values.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;
using testing::HasSubstr;
using ui::commands::Undo;

TEST(DeclarationInWindow, GravityActsOtherwiseAfterTheChoiceAndUndoBringsItBack) {
    OpenedBeam beam("declared_gravity");
    const std::string before = beam.text();
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const double falls = beam.last_height_m();
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/gravity");
    beam.driver.click("support/gravity/none");
    EXPECT_TRUE(beam.driver.state().scene->gravity_m_s2.isZero());
    EXPECT_FALSE(beam.driver.state().run_is_current());
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_GT(beam.last_height_m(), falls + 0.002);
    EXPECT_EQ(beam.text(), before) << "the file is written on request only";
    beam.driver.click("support/save");
    EXPECT_NE(beam.text(), before);
    EXPECT_THAT(beam.text(), HasSubstr("gravity_m_s2 = [0.0, 0.0, 0.0]"));
    beam.driver.workbench->execute(Undo{});
    EXPECT_NEAR(beam.driver.state().scene->gravity_m_s2.z(), -9.81, 0.02);
}

TEST(DeclarationInWindow, HeldAtTheOtherEndTheBodyIsMeshedAgain) {
    OpenedBeam beam("declared_support");
    EXPECT_TRUE(beam.driver.state().mesh_is_current());
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/end");
    beam.driver.click("support/end/x_high");
    EXPECT_GT(beam.driver.state().scene->clamp_m->lowest.x(), 0.05);
    EXPECT_FALSE(beam.driver.state().mesh_is_current());
    EXPECT_THAT(ui::commands::task_status(beam.driver.state(), ui::commands::Task::mesh).next, HasSubstr("held part"));
    beam.driver.workbench->execute(Undo{});
    EXPECT_TRUE(beam.driver.state().mesh_is_current());
}

TEST(DeclarationInWindow, AnEditThatIsNoExperimentIsRefusedWithASentence) {
    OpenedBeam beam("declared_refused");
    const ui::commands::Settings before = beam.driver.state().settings;
    beam.driver.workbench->execute(ui::commands::EditDeclaration{
        {ui::commands::SetDeclared{{"clamp", "box_m"}, "[[9.0, 9.0, 9.0], [9.1, 9.1, 9.1]]"}}, "far"});
    EXPECT_EQ(beam.driver.state().settings, before);
    EXPECT_THAT(beam.driver.state().refused, HasSubstr("clamp.box_m"));
    EXPECT_FALSE(beam.driver.state().can_undo && beam.driver.state().settings.declaration.text);
    // What is settled is no longer said in the bar.
    beam.driver.workbench->execute(ui::commands::EditDeclaration{
        {ui::commands::SetDeclared{{"environment", "gravity_m_s2"}, "[0.0, 0.0, 0.0]"}}, "gravity"});
    EXPECT_EQ(beam.driver.state().refused, "");
    EXPECT_NE(beam.driver.state().log.back().level, ui::commands::LogLevel::failure);
}

TEST(DeclarationInWindow, ATrialIsAddedLoadedRunAndRemoved) {
    OpenedBeam beam("declared_trial");
    const std::size_t count = beam.driver.state().scene->trials.size();
    beam.driver.window->show_panel("trial");
    beam.driver.settle();
    beam.driver.click("trial/add");
    ASSERT_EQ(beam.driver.state().scene->trials.size(), count + 1);
    EXPECT_EQ(beam.driver.state().trial, static_cast<int>(count));
    EXPECT_EQ(beam.driver.state().scene_trial()->role, "simulate");
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const double alone = beam.last_height_m();
    beam.driver.window->show_panel("trial");
    beam.driver.settle();
    beam.driver.click("trial/add_force");
    ASSERT_EQ(beam.driver.state().scene_trial()->loads.size(), 1u);
    EXPECT_NEAR(beam.driver.state().scene_trial()->loads[0].force_N.z(), -0.1, 1e-12);
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_LT(beam.last_height_m(), alone - 0.001) << "the force pulls the free end down";
    beam.driver.workbench->execute(Undo{});
    EXPECT_TRUE(beam.driver.state().scene_trial()->loads.empty());
    beam.driver.window->show_panel("trial");
    beam.driver.settle();
    beam.driver.click("trial/remove");
    EXPECT_EQ(beam.driver.state().scene->trials.size(), count);
}

TEST(DeclarationInWindow, ARecordingIsKeptForValidation) {
    OpenedBeam beam("declared_role");
    ASSERT_EQ(beam.driver.state().scene_trial()->role, "fit");
    beam.driver.window->show_panel("trial");
    beam.driver.settle();
    beam.driver.click("trial/role");
    beam.driver.click("trial/role/validate");
    EXPECT_EQ(beam.driver.state().scene_trial()->role, "validate") << beam.driver.state().refused;
    beam.driver.workbench->execute(Undo{});
    EXPECT_EQ(beam.driver.state().scene_trial()->role, "fit");
}

TEST(DeclarationInWindow, UnknownValuesAreTicked) {
    OpenedBeam beam("declared_unknown");
    const std::vector<std::string> before = beam.driver.state().scene->unknowns;
    ASSERT_THAT(before, testing::Contains("damping"));
    beam.driver.window->show_panel("unknown");
    beam.driver.settle();
    beam.driver.click("unknown/damping");
    EXPECT_THAT(beam.driver.state().scene->unknowns, testing::Not(testing::Contains("damping")))
        << beam.driver.state().refused;
    EXPECT_EQ(beam.driver.state().scene->calibrated.size(), before.size() - 1);
}

/// From a surface alone to a run with gravity along its axis, without a text editor.
TEST(DeclarationInWindow, MakesAnExperimentOfASurface) {
    const test::Folder folder("declared_surface");
    ASSERT_TRUE(
        mesh::write_stl(folder.path() / "bar.stl", mesh::box_surface(Box{{0.0, 0.0, 0.0}, {0.08, 0.02, 0.02}}), 1.0));
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.workbench->execute(ui::commands::Open{folder.path() / "bar.stl", 1.0});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_FALSE(driver.state().scene->is_experiment);
    driver.workbench->execute(ui::commands::MakeExperiment{folder.path() / "bar"});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene->is_experiment) << driver.state().log.back().text;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "bar" / "body.stl"));
    driver.window->show_panel("support");
    driver.settle();
    driver.click("support/gravity");
    driver.click("support/gravity/x_high");
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    EXPECT_TRUE(driver.state().run->problem.empty()) << driver.state().run->problem;
    // The bar hangs along its axis: its free end stays on it and is stretched.
    const ui::commands::SimulatedTrial& shown = *driver.state().simulated_trial();
    EXPECT_GT(shown.frames.back().row(0).maxCoeff(), 0.08);
    EXPECT_NEAR(shown.frames.back().row(2).minCoeff(), 0.0, 2e-4);
}

}  // namespace
}  // namespace myo
