#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

void set_modulus(Driver& driver, double E) {
    Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa = E;
    driver.workbench->execute(command::ChangeSettings{settings, "test", false});
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
    driver.workbench->execute(command::Run{});
    set_modulus(driver, 3.0e5);
    driver.workbench->execute(command::Run{});
    set_modulus(driver, 4.0e5);
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
    std::this_thread::sleep_for(std::chrono::milliseconds(30));   // the step that was under way
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
    EXPECT_EQ(driver.state().history[0].outcome, JobOutcome::stopped);
}

TEST(Jobs, EndedOnesAreComparedRestoredAndForgotten) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    const auto first = driver.state().run;
    set_modulus(driver, 5.0e5);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(driver.state().history.size(), 2u);
    const JobRecord record = driver.state().history[0];
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
    set_modulus(driver, 5.0e5);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(command::SetTime{0.06});
    ViewOptions view = driver.state().view;
    view.measured = false;   // orange spheres and red error lines are near the ring's colour
    driver.workbench->execute(command::ChangeView{view});
    driver.settle();
    const SceneTrial& trial = *driver.state().scene_trial();
    Eigen::Index sample = 0;
    (trial.time_s.array() - 0.06).abs().minCoeff(&sample);
    const ImVec4 color = make_theme(ThemeName::dark, 1.0f).muscle(0);
    const auto ring_drawn = [&] { return test::color_near(driver.picture(), test::pixel_of(driver, soft->trials[0].markers[0].col(sample)), color, 14); };
    EXPECT_FALSE(ring_drawn());
    driver.workbench->execute(command::CompareRecord{driver.state().history[0].id, true});
    driver.settle();
    EXPECT_TRUE(ring_drawn());
    driver.workbench->execute(command::CompareRecord{driver.state().history[0].id, false});
    driver.settle();
    EXPECT_FALSE(ring_drawn());
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
    driver.click("step/fit");
    EXPECT_TRUE(driver.has("search/rms"));
    EXPECT_TRUE(driver.has("search/gradient"));
    set_modulus(driver, 4.4e5);
    driver.backend->hold_search = false;
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 4.4e5) << "an edit made meanwhile is not overwritten";
    ASSERT_TRUE(driver.state().found);
    driver.workbench->execute(command::RestoreRecord{driver.state().history.back().id});
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, test::SwingingBeam::measured_modulus);
}

TEST(Jobs, OptimisesTheSignalOfAMuscle) {
    Driver driver;
    driver.open_beam();
    driver.click("step/fibres");
    driver.click("fibres/add");
    driver.click("step/fit");
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

}  // namespace
}  // namespace myo
