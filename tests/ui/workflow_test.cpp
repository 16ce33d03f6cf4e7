#include <gtest/gtest.h>

#include "commands/marker_errors.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

commands::TaskState state_of(const Driver& driver, commands::Task task) {
    return commands::task_status(driver.state(), task).state;
}

TEST(Workflow, StepsSayWhatIsMissingStaleAndDone) {
    Driver driver;
    EXPECT_EQ(state_of(driver, commands::Task::body), commands::TaskState::missing);
    EXPECT_EQ(state_of(driver, commands::Task::run), commands::TaskState::missing);
    EXPECT_EQ(commands::next_task(driver.state()), commands::Task::body);
    driver.open_beam();
    EXPECT_EQ(state_of(driver, commands::Task::body), commands::TaskState::done);
    EXPECT_EQ(state_of(driver, commands::Task::mesh), commands::TaskState::done);
    EXPECT_EQ(state_of(driver, commands::Task::fibres), commands::TaskState::ready);
    EXPECT_EQ(state_of(driver, commands::Task::run), commands::TaskState::ready);
    EXPECT_EQ(state_of(driver, commands::Task::report), commands::TaskState::missing);
    driver.click("run/calibrate");
    ASSERT_TRUE(driver.wait_for_job());
    for (const commands::Task task : {commands::Task::run, commands::Task::measure, commands::Task::fit})
        EXPECT_EQ(state_of(driver, task), commands::TaskState::done) << commands::task_id(task);
    driver.workbench->execute(commands::Diagnose{});
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(state_of(driver, commands::Task::diagnose), commands::TaskState::done);
    driver.click("diagnose/add");
    EXPECT_EQ(state_of(driver, commands::Task::diagnose), commands::TaskState::done)
        << "an effect it found is no reason to ask again";
    EXPECT_EQ(state_of(driver, commands::Task::run), commands::TaskState::stale);
    commands::Settings finer = driver.state().settings;
    finer.resolution_m *= 0.5;
    driver.workbench->execute(commands::ChangeSettings{finer, "test", false});
    for (const commands::Task task : {commands::Task::mesh, commands::Task::run, commands::Task::measure,
                                      commands::Task::fit, commands::Task::diagnose, commands::Task::report})
        EXPECT_EQ(state_of(driver, task), commands::TaskState::stale) << commands::task_id(task);
    EXPECT_EQ(commands::next_task(driver.state()), commands::Task::mesh);
}

TEST(Workflow, EachStepShowsItsPanelsAndWhatBelongsToItBelow) {
    Driver driver;
    driver.open_beam();
    for (const auto& [task, panel, below] : {std::tuple{"mesh", "body/element", ""},
                                             {"material", "model/density", ""},
                                             {"fibres", "fibres/add", "signals"},
                                             {"run", "model/time_step", ""},
                                             {"measure", "measure/marker/middle", "markers"},
                                             {"fit", "fit/calibrate", "search"},
                                             {"diagnose", "panel/verdict", "diagnose"}}) {
        driver.click(std::string("task/") + task);
        EXPECT_TRUE(driver.has(panel)) << task;
        EXPECT_TRUE(driver.has("task/next")) << task;
        if (*below) {
            EXPECT_TRUE(driver.has(std::string("panel/") + below)) << task;
        }
    }
    driver.click("task/fibres");
    EXPECT_FALSE(driver.has("model/density"));
}

TEST(Workflow, AnotherMeshIsNoMaterial) {
    Driver driver;
    driver.window->open("/body.stl");
    driver.settle();
    driver.click("unit/mm");
    ASSERT_TRUE(driver.wait_for_job());
    // A body alone: its material is assumed until it is set.
    commands::WorkbenchState state = driver.state();
    commands::Scene alone = *state.scene;
    for (commands::SceneTrial& trial : alone.trials) trial.role = "simulate";
    state.scene = std::make_shared<const commands::Scene>(alone);
    state.settings.resolution_m *= 0.5;
    EXPECT_EQ(commands::task_status(state, commands::Task::material).state, commands::TaskState::ready);
    state.settings.density_kg_m3 += 1.0;
    EXPECT_EQ(commands::task_status(state, commands::Task::material).state, commands::TaskState::done);
}

TEST(Workflow, WritesAReport) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.click("task/report");
    const auto folder = std::filesystem::temp_directory_path() / "myoloop_report_test";
    std::filesystem::remove_all(folder);
    driver.click("report/folder");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(folder.string());
    driver.key(ImGuiKey_Tab);
    driver.click("report/write");
    driver.settle();
    ASSERT_EQ(driver.backend->reports.size(), 1u);
    EXPECT_EQ(driver.backend->reports.front(), folder);
    EXPECT_TRUE(std::filesystem::exists(folder / "picture.png"));
    EXPECT_NE(driver.state().log.back().text.find(": 2 files."), std::string::npos) << driver.state().log.back().text;
    std::filesystem::remove_all(folder);
}

TEST(MarkerErrors, AreThoseOfTheDefinition) {
    commands::Scene scene;
    scene.markers = {{"a", {}}, {"b", {}}};
    commands::SceneTrial trial{
        "t", "fit", Eigen::Vector4d(-1.0, 0.0, 1.0, 2.0), {Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xd::Zero(3, 4)}};
    trial.measured[1].col(2).setConstant(std::numeric_limits<double>::quiet_NaN());
    commands::SimulatedTrial simulated;
    simulated.markers = {Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xd::Zero(3, 4)};
    simulated.markers[0].row(0) << 9.0, 1e-3, 2e-3, 3e-3;  // before the start it does not count
    simulated.markers[0].row(2) << 9.0, 0.0, -4e-3, 0.0;
    const std::vector<commands::MarkerError> errors = commands::marker_errors(scene, trial, &simulated);
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_NEAR(errors[0].rms_m, std::sqrt((1.0 + 4.0 + 9.0 + 16.0) / 9.0) * 1e-3, 1e-12);
    EXPECT_NEAR(errors[0].largest_m, std::sqrt(20.0) * 1e-3, 1e-12);
    EXPECT_NEAR(errors[0].bias_m.x(), 2e-3, 1e-12);
    EXPECT_NEAR(errors[0].rms_axis_m.z(), 4e-3 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(errors[1].seen, 2.0 / 3.0, 1e-12);
    EXPECT_EQ(errors[1].rms_m, 0.0);
    EXPECT_TRUE(std::isnan(commands::marker_errors(scene, trial, nullptr)[0].rms_m));
}

}  // namespace
}  // namespace myo::ui
