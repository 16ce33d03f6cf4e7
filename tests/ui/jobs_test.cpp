#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "commands/settings_difference.hpp"
#include "panels/job_text.hpp"
#include "plot/number_text.hpp"
#include "ui/drawn_text.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

void set_youngs_modulus(Driver& driver, double E) {
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa = E;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
}

void wait_for_evaluation(Driver& driver) {
    for (int i = 0; i < 2000 && !(driver.state().search && !driver.state().search->log.empty()); ++i) {
        driver.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(driver.state().search && !driver.state().search->log.empty());
}

TEST(Jobs, WaitTheirTurnAndRunWithTheSettingsOfTheirTime) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.002;
    driver.workbench->execute(commands::Run{});
    set_youngs_modulus(driver, 3.0e5);
    driver.workbench->execute(commands::Run{});
    set_youngs_modulus(driver, 4.0e5);
    ASSERT_EQ(driver.state().queue.size(), 1u);
    EXPECT_EQ(driver.state().queue.front().name, "Simulate");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(driver.state().history.size(), 2u);
    EXPECT_EQ(driver.state().history[0].settings.youngs_modulus_Pa, 2.6e5);
    EXPECT_EQ(driver.state().history[1].settings.youngs_modulus_Pa, 3.0e5);
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 4.0e5);
    EXPECT_FALSE(driver.state().run_is_current()) << "the shown run is of the second job";
}

TEST(Jobs, PauseHoldsTheWorkAndItsClock) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.001;
    driver.click("run/run");
    ASSERT_TRUE(driver.state().busy());
    driver.click("run/pause");
    ASSERT_TRUE(driver.state().job->paused);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));  // the step that was under way
    driver.frame();
    const double done = driver.state().job->progress.done, elapsed = driver.state().job->elapsed_s;
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    driver.frame();
    EXPECT_EQ(driver.state().job->progress.done, done);
    EXPECT_NEAR(driver.state().job->elapsed_s, elapsed, 1e-3);
    driver.click("run/pause");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().run);
}

TEST(Jobs, APausedJobCanBeCancelled) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.001;
    driver.click("run/run");
    driver.click("run/pause");
    driver.click("run/cancel");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().run);
    ASSERT_EQ(driver.state().history.size(), 1u);
    EXPECT_EQ(driver.state().history[0].outcome, commands::JobOutcome::stopped);
}

TEST(Jobs, EndedOnesAreComparedRestoredAndForgotten) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    const auto first = driver.state().run;
    set_youngs_modulus(driver, 5.0e5);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(driver.state().history.size(), 2u);
    const commands::JobRecord record = driver.state().history[0];
    driver.click("panel/jobs");
    driver.click("jobs/compare/" + std::to_string(record.id));
    EXPECT_TRUE(driver.state().history[0].compared);
    driver.click("panel/markers");
    EXPECT_TRUE(driver.has("plot/x/legend/Simulate " + record.clock)) << "its curve is in the plots";
    driver.click("panel/jobs");
    driver.click("jobs/restore/" + std::to_string(record.id));
    EXPECT_EQ(driver.state().run, first);
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 2.6e5);
    EXPECT_TRUE(driver.state().run_is_current());
    driver.click("bar/undo");
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 5.0e5);
    driver.click("jobs/forget/" + std::to_string(record.id));
    ASSERT_EQ(driver.state().history.size(), 1u);
    EXPECT_NE(driver.state().history[0].id, record.id);
}

TEST(Jobs, ComparedOnesHaveRingsInTheView) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    const auto soft = driver.state().run;
    set_youngs_modulus(driver, 5.0e5);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{0.06});
    commands::ViewOptions view = driver.state().view;
    view.measured = false;  // orange spheres and red error lines are near the ring's colour
    driver.workbench->execute(commands::ChangeView{view});
    driver.settle();
    const commands::SceneTrial& trial = *driver.state().scene_trial();
    Eigen::Index sample = 0;
    (trial.time_s.array() - 0.06).abs().minCoeff(&sample);
    const ImVec4 color = platform::make_theme(platform::ThemeName::dark, 1.0f).muscle(0);
    const auto ring_drawn = [&] {
        return test::color_near(driver.picture(), test::pixel_of(driver, soft->trials[0].markers[0].col(sample)), color,
                                14);
    };
    EXPECT_FALSE(ring_drawn());
    driver.workbench->execute(commands::CompareRecord{driver.state().history[0].id, true});
    driver.settle();
    EXPECT_TRUE(ring_drawn());
    driver.workbench->execute(commands::CompareRecord{driver.state().history[0].id, false});
    driver.settle();
    EXPECT_FALSE(ring_drawn());
}

/// The beam with a run in its history, and a finer mesh asked for.
void run_and_refine(Driver& driver) {
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    commands::Settings settings = driver.state().settings;
    settings.resolution_m *= 0.5;
    driver.workbench->execute(commands::ChangeSettings{settings, "resolution", false});
    driver.workbench->execute(commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job());
}

TEST(Jobs, WhatARunBringsIsShownOnItsOwnBody) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_and_refine(driver));
    const auto fine = driver.state().body;
    driver.backend->step_delay_s = 0.002;
    driver.workbench->execute(commands::Run{});
    driver.frame();
    driver.workbench->execute(commands::RestoreRecord{driver.state().history[0].id});
    ASSERT_NE(driver.state().body, fine);
    driver.settle();
    EXPECT_TRUE(driver.state().run_is_current());
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{0.3});
    driver.settle();
    EXPECT_EQ(driver.state().body, fine);
    ASSERT_TRUE(driver.state().simulated_trial());
    EXPECT_EQ(driver.state().simulated_trial()->frames.front().cols(), fine->mesh.node_count());
    EXPECT_EQ(driver.window->scene().positions.cols(), fine->mesh.node_count());
    EXPECT_EQ(driver.state().history.back().on.body, fine);
    EXPECT_TRUE(driver.state().history.back().run);
}

TEST(Jobs, ASearchOnAnotherBodyIsNotShownOnTheRestoredOne) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_and_refine(driver));
    driver.backend->hold_search = true;
    driver.click("run/calibrate");
    ASSERT_NO_FATAL_FAILURE(wait_for_evaluation(driver));
    EXPECT_EQ(driver.state().shown_run(), driver.state().search->best);
    driver.workbench->execute(commands::RestoreRecord{driver.state().history[0].id});
    driver.settle();
    EXPECT_EQ(driver.state().shown_run(), driver.state().history[0].run);
    EXPECT_EQ(driver.window->scene().positions.cols(), driver.state().body->mesh.node_count());
    driver.backend->hold_search = false;
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.window->scene().positions.cols(), driver.state().body->mesh.node_count());
    EXPECT_EQ(driver.state().run->trials.front().frames.front().cols(), driver.state().body->mesh.node_count());
}

TEST(Jobs, ComparedOnesTellTheSettingsInWhichTheyDiffer) {
    Driver driver(1600, 900);
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    set_youngs_modulus(driver, 5.0e5);
    const commands::Settings soft = driver.state().history[0].settings, stiff = driver.state().settings;
    const std::vector<commands::SettingDifference> rows = commands::settings_differences(
        {&soft, &stiff}, driver.state().materials, driver.state().integrators);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].name, "Young's modulus E");
    EXPECT_EQ(rows[0].values, (std::vector<std::string>{"260 kPa", "500 kPa"}));
    driver.click("panel/jobs");
    EXPECT_FALSE(driver.has("jobs/differences"));
    driver.click("jobs/compare/" + std::to_string(driver.state().history[0].id));
    EXPECT_TRUE(driver.has("jobs/differences"));
    EXPECT_TRUE(driver.has("jobs/differs/Young's modulus E"));
}

TEST(Jobs, SignalsThatDifferDoNotReadAlike) {
    commands::Settings a, b;
    commands::Muscle muscle;
    muscle.name = "upper";
    muscle.signal = fibre::Signal{{0.0, 1.0}, {1.0, 0.8}};
    a.muscles = {muscle};
    muscle.signal = fibre::Signal{{0.0, 0.5}, {1.0, 0.8}};
    b.muscles = {muscle};
    b.effects = {{{"quadratic_drag", {}, true}, "Quadratic drag", "coefficient 903 kg/m\xc2\xb3"}};
    const std::vector<commands::SettingDifference> rows = commands::settings_differences({&a, &b}, {}, {});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].name, "Quadratic drag");
    EXPECT_EQ(rows[1].name, "upper, signal");
    EXPECT_NE(rows[1].values[0], rows[1].values[1]);
    EXPECT_TRUE(commands::settings_differences({&a, &a}, {}, {}).empty());
}

TEST(Jobs, AreAskedForBeforeTheWindowCloses) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.002;
    driver.workbench->execute(commands::Run{});
    driver.workbench->execute(commands::Quit{});
    driver.settle();
    EXPECT_FALSE(driver.state().quit);
    driver.click("stop/keep");
    EXPECT_FALSE(driver.state().quit);
    EXPECT_FALSE(driver.has("stop/keep"));
    EXPECT_TRUE(driver.state().busy());
    // One that ends by itself takes the question with it.
    driver.workbench->execute(commands::Quit{});
    driver.settle();
    ASSERT_TRUE(driver.has("stop/quit"));
    ASSERT_TRUE(driver.wait_for_job());
    driver.settle();
    EXPECT_FALSE(driver.has("stop/quit"));
    EXPECT_FALSE(driver.state().quit);
    driver.click("run/run");
    ASSERT_TRUE(driver.state().busy()) << "nothing is left that takes the clicks";
    driver.workbench->execute(commands::Quit{});
    driver.settle();
    driver.click("stop/quit");
    EXPECT_TRUE(driver.state().quit);
}

TEST(Jobs, TellWhatTheyCountAndTheTimeLeft) {
    commands::JobView job;
    job.progress = {"fit", 12.0, 40.0, "evaluations", ""};
    job.elapsed_s = 30.0;
    job.remaining_s = 70.0;
    job.remaining_of = commands::TimeLeft::at_most;
    EXPECT_EQ(panels::counted_text(job), "12 of 40 evaluations");
    // A part of an evaluation is no evaluation, and the parts of a job are named.
    commands::JobView part = job;
    part.name = "Calibrate";
    part.progress = {"other moduli", 5.4, 6.0, "runs", {}};
    EXPECT_EQ(panels::counted_text(part), "5 of 6 runs");
    EXPECT_EQ(panels::stage_words(part), "Other moduli");
    part.progress.task = "fit";
    EXPECT_EQ(panels::stage_words(part), "");
    EXPECT_EQ(panels::time_text(job), "at most 70 s left of this phase");
    EXPECT_EQ(panels::bar_text(job), "30 %");
    job.remaining_of = commands::TimeLeft::of_phase;
    EXPECT_EQ(panels::time_text(job), "less than 2 min left of this phase");
    // TetGen does not say how far it is, nor does a phase that is only named.
    job.remaining_s.reset();
    for (const ProgressEvent& event :
         {ProgressEvent{"tetrahedral mesh", 6.0, 0.0, "s", ""}, {"significance", 1.0, 1.0, "phase", ""}}) {
        job.progress = event;
        EXPECT_EQ(panels::counted_text(job), "");
        EXPECT_EQ(panels::bar_text(job), "working");
        EXPECT_EQ(job.fraction(), 0.0);
        EXPECT_EQ(panels::time_text(job), "30 s so far");
    }
}

TEST(Jobs, ASearchTellsTheMostTimeThatIsLeft) {
    Driver driver;
    driver.open_beam();
    driver.backend->hold_search = true;
    driver.click("run/calibrate");
    ASSERT_NO_FATAL_FAILURE(wait_for_evaluation(driver));
    EXPECT_EQ(driver.state().job->remaining_of, commands::TimeLeft::at_most);
    driver.click("panel/jobs");
    EXPECT_TRUE(driver.has("jobs/progress"));
    driver.backend->hold_search = false;
    ASSERT_TRUE(driver.wait_for_job());
}

TEST(Jobs, TimeLeftIsOfThePresentCount) {
    std::atomic<bool> goes_on = false;
    const auto work = [&](const Progress& progress) -> commands::Job::Completion {
        progress.report({"mesh", 90.0, 100.0, "rows", {}});
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        progress.report({"simulate", 0.0, 2.0, "s", {}});
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
        progress.report({"simulate", 1.0, 2.0, "s", {}});
        while (!goes_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return [] {};
    };
    commands::Job job("job", work, [](const std::string&) { return [] {}; }, {});
    while (job.view().progress.done != 1.0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const commands::JobView view = job.view();
    ASSERT_TRUE(view.remaining_s);
    EXPECT_GT(view.elapsed_s, 1.25);
    EXPECT_LT(*view.remaining_s, view.elapsed_s - 0.5) << "the time of the mesh does not count";
    goes_on = true;
}

/// A count that goes back and then counts on from there: what was done before it went back is no speed.
TEST(Jobs, TimeLeftAfterACountThatWentBackIsNotTooShort) {
    std::atomic<bool> goes_on = false;
    const auto work = [&](const Progress& progress) -> commands::Job::Completion {
        progress.report({"optimize", 30.9, 60.0, "evaluations", {}});
        progress.report({"optimize", 30.0, 60.0, "evaluations", {}});
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
        progress.report({"optimize", 33.0, 60.0, "evaluations", {}});
        while (!goes_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return [] {};
    };
    commands::Job job("job", work, [](const std::string&) { return [] {}; }, {}, {.searches = true});
    while (job.view().progress.done != 33.0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const commands::JobView view = job.view();
    goes_on = true;
    ASSERT_TRUE(view.remaining_s);
    EXPECT_GT(*view.remaining_s, 0.6 / 3.0 * 27.0 - 0.1) << "three evaluations took 0.6 s, and 27 are left";
    EXPECT_EQ(view.remaining_of, commands::TimeLeft::at_most);
}

TEST(Jobs, ASearchLeavesTheNumbersOfTheLastRun) {
    Driver driver(1280, 1400);
    driver.open_beam();
    driver.window->show_task(commands::Task::run);
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    const std::shared_ptr<const commands::RunResult> run = driver.state().run;
    const auto row = [&] {
        std::string texts;
        const platform::Rectangle place = driver.item("run/trial/gravity_release");
        for (const test::DrawnText& text : test::drawn_text())
            if (place.contains(text.part.center())) texts += text.text + "|";
        return texts;
    };
    const auto error = [](const commands::RunResult& of) { return plot::value_label(1e3 * of.trials[0].rms_m, 3); };
    const std::string before = row();
    ASSERT_NE(before.find(error(*run)), std::string::npos) << before;
    set_youngs_modulus(driver, 6e5);
    driver.backend->hold_search = true;
    driver.workbench->execute(commands::Calibrate{});
    ASSERT_NO_FATAL_FAILURE(wait_for_evaluation(driver));
    driver.settle();
    ASSERT_EQ(driver.state().shown_run(), driver.state().search->best);
    ASSERT_NE(error(*driver.state().search->best), error(*run));
    EXPECT_EQ(row(), before) << "all trials, time and warnings are of the run, too";
    driver.backend->hold_search = false;
    ASSERT_TRUE(driver.wait_for_job());
}

TEST(Jobs, ASearchShowsItsBestSoFarAndLeavesEditsAlone) {
    Driver driver;
    driver.open_beam();
    driver.backend->hold_search = true;
    driver.click("run/calibrate");
    ASSERT_NO_FATAL_FAILURE(wait_for_evaluation(driver));
    ASSERT_TRUE(driver.state().searching());
    EXPECT_EQ(driver.state().shown_run(), driver.state().search->best);
    EXPECT_FALSE(driver.state().run);
    EXPECT_TRUE(driver.state().playing);
    driver.click("task/fit");
    EXPECT_TRUE(driver.has("search/rms"));
    EXPECT_TRUE(driver.has("search/gradient"));
    set_youngs_modulus(driver, 4.4e5);
    driver.backend->hold_search = false;
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 4.4e5) << "an edit made meanwhile is not overwritten";
    ASSERT_TRUE(driver.state().found);
    driver.workbench->execute(commands::RestoreRecord{driver.state().history.back().id});
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, test::SwingingBeam::measured_modulus);
}

TEST(Jobs, OptimisesTheSignalOfAMuscle) {
    Driver driver;
    driver.open_beam();
    driver.click("task/fibres");
    driver.click("fibres/add");
    driver.click("task/fit");
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().search->log.size(), 5u);
    ASSERT_TRUE(driver.state().settings.muscles[0].signal);
    EXPECT_DOUBLE_EQ(driver.state().settings.muscles[0].signal->values.back(), 0.8);
    EXPECT_TRUE(driver.state().run_is_current());
    driver.click("bar/undo");
    EXPECT_DOUBLE_EQ(driver.state().settings.muscles[0].signal->times_s.back(), 0.5) << "the signal that was drawn";
}

TEST(Job, ExceptionsBecomeMessages) {
    std::string told;
    commands::Job job(
        "work", [](const Progress&) -> commands::Job::Completion { throw std::runtime_error("out of everything"); },
        [&told](const std::string& what) -> commands::Job::Completion { return [&told, what] { told = what; }; }, {});
    std::optional<commands::Job::Completion> completion;
    for (int i = 0; i < 500 && !completion; ++i) {
        completion = job.take_result();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(completion);
    (*completion)();
    EXPECT_EQ(told, "out of everything");
    EXPECT_FALSE(job.take_result()) << "a result is handed over once";
}

TEST(Job, TimeLeftIsARange) {
    EXPECT_EQ(panels::time_left_range(3.0), "less than 5 s");
    EXPECT_EQ(panels::time_left_range(40.0), "30 to 60 s");
    EXPECT_EQ(panels::time_left_range(160.0), "2 to 4 min");
    EXPECT_EQ(panels::time_left_range(1200.0), "15 to 30 min");
    EXPECT_EQ(panels::time_left_range(4.0 * 3600.0), "3 to 6 h");
}

TEST(Job, NeverCountsBeyondItsTotal) {
    std::atomic<bool> goes_on = false;
    const auto work = [&](const Progress& progress) -> commands::Job::Completion {
        progress.report({"fit", 41.0, 40.0, "evaluations", {}});
        while (!goes_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return [] {};
    };
    commands::Job job("job", work, [](const std::string&) { return [] {}; }, {});
    while (job.view().progress.done == 0.0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(panels::counted_text(job.view()), "40 of 40 evaluations");
    EXPECT_EQ(panels::bar_text(job.view()), "100 %");
    goes_on = true;
}

TEST(Job, TimeLeftIsToldOnceItMeansSomething) {
    EXPECT_FALSE(commands::remaining_time(0.0, 10.0));
    EXPECT_FALSE(commands::remaining_time(0.5, 0.1));
    EXPECT_NEAR(commands::remaining_time(0.25, 10.0).value(), 30.0, 1e-12);
}

}  // namespace
}  // namespace myo::ui
