#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/driver.hpp"

// What is taken away from the window: the body, the experiment, projects with their files.

namespace myo::ui {
namespace {

using test::Driver;

void open_export(Driver& driver) {
    driver.click("menu/file");
    driver.click("menu/file.export");
}

/// Chooses the proposed name in the file browser.
void save(Driver& driver) {
    ASSERT_TRUE(driver.has("browser/name"));
    driver.click("browser/open");
    ASSERT_TRUE(driver.wait_for_job());
}

TEST(ExportBody, WritesTheShownTimeInTheChosenFormat) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    commands::ViewOptions view = driver.state().view;
    view.field = "height";
    driver.workbench->execute(commands::ChangeView{view});
    driver.workbench->execute(commands::SetTime{0.3});
    open_export(driver);
    driver.click("export/glb");
    driver.click("export/where");
    ASSERT_NO_FATAL_FAILURE(save(driver));
    ASSERT_EQ(driver.backend->shapes.size(), 1u);
    const auto& [file, frame] = driver.backend->shapes[0];
    EXPECT_EQ(file.filename(), "gravity_release.glb");
    EXPECT_EQ(frame.positions_m, driver.window->scene().positions);
    EXPECT_EQ(frame.values.size(), frame.positions_m.cols());
    EXPECT_EQ(frame.colours.cols(), frame.positions_m.cols());
    EXPECT_THAT(frame.field, testing::HasSubstr("[mm]"));
    EXPECT_GT((frame.colours.rowwise().maxCoeff() - frame.colours.rowwise().minCoeff()).maxCoeff(), 0.2f);
    open_export(driver);
    driver.click("export/stl");
    driver.click("export/where");
    ASSERT_NO_FATAL_FAILURE(save(driver));
    EXPECT_EQ(driver.backend->shapes[1].first.extension(), ".stl");
    EXPECT_EQ(driver.backend->shapes[1].second.metres_per_unit, 1e-3);
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::done);
}

TEST(ExportBody, WritesAllFramesWithTheirTimes) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    open_export(driver);
    driver.click("export/frames");
    driver.click("export/frames/all");
    driver.click("export/where");
    ASSERT_NO_FATAL_FAILURE(save(driver));
    const commands::SimulatedTrial& trial = *driver.state().simulated_trial();
    ASSERT_EQ(driver.backend->shapes.size(), trial.frames.size());
    ASSERT_EQ(driver.backend->series.size(), 1u);
    const test::SwingingBeam::ShapeSeries& series = driver.backend->series[0];
    EXPECT_EQ(series.file.filename(), "gravity_release.pvd");
    ASSERT_EQ(series.times_s.size(), trial.frames.size());
    for (std::size_t f = 0; f < trial.frames.size(); ++f) {
        EXPECT_EQ(driver.backend->shapes[f].second.positions_m, trial.frames[f]);
        EXPECT_EQ(series.times_s[f], trial.frame_time_s(static_cast<Eigen::Index>(f)));
        EXPECT_EQ(series.file.parent_path() / series.files[f], driver.backend->shapes[f].first);
    }
}

TEST(ExportBody, WithoutARunIsTheBodyAtRest) {
    Driver driver;
    driver.open_beam();
    open_export(driver);
    driver.click("export/frames");
    driver.click("export/frames/all");
    driver.click("export/where");
    EXPECT_FALSE(driver.has("browser/name")) << "there are no frames";
    driver.click("export/frames");
    driver.click("export/frames/shown");
    driver.click("export/where");
    ASSERT_NO_FATAL_FAILURE(save(driver));
    ASSERT_EQ(driver.backend->shapes.size(), 1u);
    EXPECT_EQ(driver.backend->shapes[0].second.positions_m, driver.state().body->mesh.nodes);
    EXPECT_EQ(driver.backend->shapes[0].second.values.size(), 0);
}

TEST(SaveExperimentAs, IsForExperimentsOnly) {
    Driver driver;
    driver.backend->as_experiment = true;
    driver.open_beam();
    driver.click("menu/file");
    driver.click("menu/file.save_experiment");
    ASSERT_TRUE(driver.has("browser/name"));
    driver.click("browser/open");
    EXPECT_EQ(driver.backend->copies.size(), 1u);
}

TEST(SelfContainedProject, StaysSoWhenItIsSavedAgainButNotInCopiesForRecovery) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.workbench->execute(commands::SaveAs{"/taken/arm.myoloop", true});
    EXPECT_TRUE(driver.backend->projects.at("/taken/arm.myoloop").self_contained);
    ASSERT_EQ(driver.backend->reports.size(), 1u);
    EXPECT_EQ(driver.backend->reports[0], "/taken/arm.files/results");
    commands::Settings settings = driver.state().settings;
    settings.density_kg_m3 += 30.0;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.workbench->autosave("/recovery/unsaved-1.myoloop");
    driver.workbench->finish_autosave();
    EXPECT_FALSE(driver.backend->projects.at("/recovery/unsaved-1.myoloop").self_contained);
    driver.workbench->execute(commands::Save{});
    EXPECT_TRUE(driver.backend->projects.at("/taken/arm.myoloop").self_contained);
    driver.workbench->execute(commands::SaveAs{"/forbidden/arm.myoloop", false});
    EXPECT_TRUE(driver.state().self_contained) << "it was not saved otherwise";
}

TEST(Locate, AProjectWithoutItsExperimentAsksForIt) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(commands::SaveAs{"/arm.myoloop"});
    Driver again;
    again.backend->projects = driver.backend->projects;
    again.backend->projects.at("/arm.myoloop").source_missing = true;
    again.backend->projects.at("/arm.myoloop").settings.density_kg_m3 = 1234.0;
    again.window->open("/arm.myoloop");
    ASSERT_TRUE(again.wait_for_job());
    EXPECT_FALSE(again.state().scene);
    ASSERT_TRUE(again.state().missing);
    again.settle();
    again.click("missing/locate");
    EXPECT_TRUE(again.has("browser/path"));
    EXPECT_FALSE(again.has("missing/locate")) << "one dialog at a time";
    again.workbench->execute(commands::Locate{"/elsewhere/beam"});
    ASSERT_TRUE(again.wait_for_job());
    ASSERT_TRUE(again.state().scene) << again.state().log.back().text;
    EXPECT_EQ(again.state().scene->path, "/elsewhere/beam");
    EXPECT_EQ(again.state().project, "/arm.myoloop");
    EXPECT_EQ(again.state().settings.density_kg_m3, 1234.0);
    EXPECT_FALSE(again.state().missing);
}

TEST(Locate, CanBeGivenUp) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(commands::SaveAs{"/arm.myoloop"});
    Driver again;
    again.backend->projects = driver.backend->projects;
    again.backend->projects.at("/arm.myoloop").source_missing = true;
    again.window->open("/arm.myoloop");
    ASSERT_TRUE(again.wait_for_job());
    again.settle();
    again.click("missing/locate");
    again.key(ImGuiKey_Escape);
    again.settle();
    EXPECT_FALSE(again.state().missing);
    EXPECT_FALSE(again.state().scene);
}

}  // namespace
}  // namespace myo::ui
