#include <gtest/gtest.h>

#include <algorithm>

#include "commands/workflow.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

void set_modulus(Driver& driver, double modulus_Pa) {
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa = modulus_Pa;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.settle();
}

/// Colours of a sign in a part of the window: whether the one is there and the other is not.
bool is_drawn_in(Driver& driver, const platform::Rectangle& part, const ImVec4& color, const ImVec4& not_this) {
    const platform::Image image = driver.picture();
    const int radius = static_cast<int>(0.5f * std::min(part.width(), part.height()));
    return test::color_near(image, part.center(), color, radius) &&
           !test::color_near(image, part.center(), not_this, radius);
}

const platform::Theme& dark() {
    static const platform::Theme theme = platform::make_theme(platform::ThemeName::dark, 1.0f);
    return theme;
}

TEST(ChecksPanel, SaysWhatItIsForBeforeThereIsAnExperiment) {
    Driver driver;
    EXPECT_TRUE(driver.has("bar/checks")) << "with its words as tooltip";
    driver.workbench->execute(commands::Open{"/body.stl", 1e-3});  // a mesh has nothing that could be checked
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().checks);
    driver.click("bar/checks");
    EXPECT_TRUE(driver.has("checks/empty"));
    EXPECT_FALSE(driver.has("checks/head"));
}

TEST(ChecksPanel, ListsWhatWasFoundTheWorstFirst) {
    Driver driver(1600, 900);
    driver.backend->start_opened = commands::CheckState::red;
    driver.open_beam();
    ASSERT_TRUE(driver.state().checks);
    EXPECT_EQ(commands::count_text(driver.state().checks->rows), "2 green, 1 red");
    EXPECT_EQ(commands::doubt_text(driver.state().checks->rows), "1 red");
    EXPECT_FALSE(driver.has("checks/head")) << "another panel is in front";
    driver.click("bar/checks");
    ASSERT_TRUE(driver.has("checks/head"));
    EXPECT_FALSE(driver.has("checks/stale"));
    ASSERT_TRUE(driver.has("checks/row/2"));
    EXPECT_FALSE(driver.has("checks/row/3"));
    EXPECT_TRUE(is_drawn_in(driver, driver.item("checks/state/0"), dark().failure, dark().success));
    EXPECT_TRUE(is_drawn_in(driver, driver.item("checks/state/1"), dark().success, dark().failure));
    const auto told = [](const commands::LogLine& line) {
        return line.level == commands::LogLevel::warning &&
               line.text.find("from where the model begins; state start") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(driver.state().log.begin(), driver.state().log.end(), told), 1);
}

TEST(ChecksPanel, FitsItsSentencesIntoANarrowWindow) {
    Driver driver(1000, 640);
    driver.backend->start_opened = commands::CheckState::amber;
    driver.open_beam();
    driver.click("bar/checks");
    const platform::Rectangle row = driver.item("checks/row/0");
    EXPECT_LE(row.highest.x, 1000.0f);
    EXPECT_GT(row.highest.y, row.lowest.y);
}

TEST(ChecksPanel, TellsThatTheSettingsChangedSince) {
    Driver driver;
    driver.open_beam();
    driver.click("bar/checks");
    EXPECT_TRUE(driver.state().checks_are_current());
    set_modulus(driver, 3.1e5);
    EXPECT_FALSE(driver.state().checks_are_current());
    EXPECT_TRUE(driver.has("checks/stale"));
    driver.click("bar/undo");
    EXPECT_TRUE(driver.state().checks_are_current());
    EXPECT_FALSE(driver.has("checks/stale"));
    set_modulus(driver, 3.1e5);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().checks_are_current());
    EXPECT_EQ(driver.state().checks->job, "Simulate");
}

/// Of a run whose start is doubtful: in the rail of steps, at its head, in the jobs, in the bar and in the messages.
TEST(ChecksPanel, WhatIsDoubtfulHasNoTick) {
    Driver driver(1600, 900);
    driver.open_beam();
    driver.backend->start_after = commands::CheckState::amber;
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::warning);
    EXPECT_NE(driver.state().log.back().text.find("Checks: 1 amber."), std::string::npos);
    const commands::TaskStatus status = commands::task_status(driver.state(), commands::Task::run);
    EXPECT_EQ(status.state, commands::TaskState::done);
    EXPECT_EQ(status.checks, commands::CheckState::amber);
    EXPECT_NE(status.next.find("Checks: 1 amber."), std::string::npos);
    EXPECT_EQ(commands::task_status(driver.state(), commands::Task::measure).checks, commands::CheckState::amber);
    EXPECT_EQ(commands::task_status(driver.state(), commands::Task::mesh).checks, commands::CheckState::green);
    driver.click("task/report");
    const platform::Rectangle step = driver.item("task/run");
    const platform::Rectangle sign{{step.highest.x - 26.0f, step.lowest.y + 8.0f},
                                   {step.highest.x - 4.0f, step.highest.y - 8.0f}};
    EXPECT_TRUE(is_drawn_in(driver, sign, dark().warning, dark().success));
    EXPECT_TRUE(is_drawn_in(driver, driver.item("bar/checks"), dark().warning, dark().success));
    driver.click("panel/jobs");
    const platform::Rectangle record = driver.item("jobs/icon/" + std::to_string(driver.state().history.back().id));
    EXPECT_TRUE(is_drawn_in(driver, record, dark().warning, dark().success));
    driver.click("run/checks");
    EXPECT_TRUE(driver.has("checks/head"));
    // Where all is well there is a tick.
    driver.backend->start_after = commands::CheckState::green;
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::done);
    EXPECT_EQ(commands::task_status(driver.state(), commands::Task::run).checks, commands::CheckState::green);
    EXPECT_TRUE(is_drawn_in(driver, driver.item("bar/checks"), dark().success, dark().warning));
    // The doubtful run is taken up again with its checks.
    driver.workbench->execute(commands::RestoreRecord{driver.state().history.front().id});
    driver.settle();
    EXPECT_EQ(commands::worst_state(driver.state().checks->rows), commands::CheckState::amber);
    EXPECT_TRUE(driver.state().checks_are_current());
}

/// Declared values that do not fit yet are for the fit to mend: the run itself is done.
TEST(ChecksPanel, ValuesThatDoNotFitLeaveTheRunItsTick) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    commands::WorkbenchState state = driver.state();
    commands::RunResult run = *state.run;
    run.checks.front().state = commands::CheckState::red;
    const std::string own = run.checks.front().task;
    const auto status_where = [&](const std::string& mended_in) {
        run.checks.front().task = mended_in;
        state.run = std::make_shared<const commands::RunResult>(run);
        return commands::task_status(state, commands::Task::run).checks;
    };
    EXPECT_EQ(status_where(own), commands::CheckState::red);
    EXPECT_EQ(status_where("fit"), commands::CheckState::green);
    EXPECT_EQ(commands::task_status(state, commands::Task::measure).checks, commands::CheckState::green);
}

TEST(ChecksPanel, ACalibrationBringsItsOwn) {
    Driver driver;
    driver.open_beam();
    driver.backend->start_after = commands::CheckState::red;
    driver.click("run/calibrate");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().checks->job, "Calibrate");
    EXPECT_TRUE(driver.state().checks_are_current()) << "they are of the values that were found";
    EXPECT_EQ(commands::task_status(driver.state(), commands::Task::fit).checks, commands::CheckState::red);
    driver.click("task/fit");
    EXPECT_TRUE(driver.has("fit/checks"));
}

TEST(TimeStepState, FollowsTheStepThatIsSet) {
    Driver driver;
    driver.open_beam();
    driver.click("task/run");
    EXPECT_TRUE(driver.has("model/frequency_error"));
    EXPECT_TRUE(driver.has("model/interval"));
    const auto state_at = [&](double h_s) {
        commands::Settings settings = driver.state().settings;
        settings.time_step_s = h_s;
        driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
        driver.settle();
        const platform::Rectangle row = driver.item("model/frequency_error");
        if (is_drawn_in(driver, row, dark().success, dark().failure)) return commands::CheckState::green;
        return is_drawn_in(driver, row, dark().failure, dark().success) ? commands::CheckState::red
                                                                        : commands::CheckState::amber;
    };
    // 7.75 Hz: 0.0099 %, 0.4 % and 4 %.
    EXPECT_EQ(state_at(1e-3), commands::CheckState::green);
    EXPECT_EQ(state_at(6.4e-3), commands::CheckState::amber);
    EXPECT_EQ(state_at(2e-2), commands::CheckState::red);
}

TEST(TimeStepState, IsTheProgramsToChooseUntilAPersonSetsIt) {
    Driver driver;
    driver.open_beam();
    driver.backend->chosen_step_s = 2e-3;
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().settings.time_step_s, 2e-3);
    EXPECT_TRUE(driver.state().run_is_current());
    EXPECT_FALSE(driver.state().unsaved()) << "nobody changed anything";
    commands::Settings settings = driver.state().settings;
    settings.time_step_s = 4e-3;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    EXPECT_TRUE(driver.state().settings.own_step);
    EXPECT_TRUE(driver.state().unsaved());
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().settings.time_step_s, 4e-3);
    driver.click("model/automatic_step");
    EXPECT_FALSE(driver.state().settings.own_step);
    EXPECT_EQ(driver.state().settings.time_step_s, driver.state().scene->settings.time_step_s);
    driver.click("model/automatic_step");
    EXPECT_TRUE(driver.state().settings.own_step) << "the step that is shown is kept";
}

}  // namespace
}  // namespace myo::ui
