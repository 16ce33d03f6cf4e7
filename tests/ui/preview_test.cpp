#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

class Preview : public ::testing::Test {
protected:
    Driver driver;

    void SetUp() override { driver.open_beam(); }
    const commands::WorkbenchState& state() const { return driver.state(); }
    void set_modulus(double E) {
        commands::Settings settings = state().settings;
        settings.youngs_modulus_Pa = E;
        driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    }
    void wait_for_preview() {
        for (int i = 0; i < 5000 && state().preview.working; ++i) {
            driver.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ASSERT_FALSE(state().preview.working);
        driver.settle();
    }
    /// Height of the tip's node in the view, against that of the beam of this modulus at the same time.
    double height_off(double E) {
        const Eigen::Matrix3Xd& rest = state().body->mesh.nodes;
        Eigen::Index tip = 0;
        rest.colwise().sum().maxCoeff(&tip);
        return std::abs(driver.window->scene().positions(2, tip) -
                        test::beam_point(rest.col(tip), E, state().time_s).z());
    }
};

TEST_F(Preview, FollowsEveryEditAndLeavesTheResultsAlone) {
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    const auto run = state().run;
    const std::size_t records = state().history.size();
    driver.workbench->execute(commands::SetTime{1.5});
    driver.click("task/material");
    driver.click("preview/on");
    ASSERT_TRUE(state().preview.on);
    EXPECT_FALSE(state().previewing()) << "the run is of these settings, nothing is to be previewed";

    const platform::Rectangle field = driver.item("model/youngs_modulus");
    driver.drag(field.center(), {field.center().x + 60.0f, field.center().y});
    const double E = state().settings.youngs_modulus_Pa;
    ASSERT_GT(E, 2.7e5);
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    ASSERT_TRUE(state().previewing());
    EXPECT_NEAR(state().time_s, 0.5, 1e-9) << "later nothing of it would be seen";
    EXPECT_LT(height_off(E), 1e-9);
    EXPECT_GT(height_off(2.6e5), 1e-4);
    EXPECT_NE(commands::preview_text(state()).find("Preview 0\xe2\x80\x93"
                                                   "0.5 s, rms error "),
              std::string::npos)
        << commands::preview_text(state());
    // Markers are compared as far as it goes.
    const commands::SimulatedTrial& trial = *state().simulated_trial();
    EXPECT_NEAR(trial.frame_time_s.tail(1)(0), 0.5, 1e-9);
    EXPECT_TRUE(trial.markers[0].col(70).allFinite());
    EXPECT_FALSE(trial.markers[0].col(71).allFinite());

    // No result of it: the whole run is what a report, the history and the steps know.
    EXPECT_EQ(state().run, run);
    EXPECT_EQ(state().history.size(), records);
    EXPECT_EQ(commands::task_status(state(), commands::Task::run).state, commands::TaskState::stale);
    EXPECT_TRUE(driver.has("timeline/preview"));

    driver.click("preview/on");
    EXPECT_EQ(state().shown_run(), run);
    EXPECT_FALSE(driver.has("timeline/preview"));
    driver.workbench->execute(commands::SetTime{0.3});
    driver.settle();
    EXPECT_LT(height_off(2.6e5), 1e-6);
}

TEST_F(Preview, IsGivenUpForANewerEdit) {
    driver.workbench->execute(commands::ChangePreview{true, 2.0});
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    driver.backend->step_delay_s = 0.02;  // two seconds a preview
    set_modulus(3.0e5);
    driver.frame();
    ASSERT_TRUE(state().preview.working);
    driver.backend->step_delay_s = 0.0;
    set_modulus(4.0e5);
    driver.workbench->execute(commands::SetTime{0.1});
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    EXPECT_LT(height_off(4.0e5), 1e-6);
    EXPECT_TRUE(state().history.empty());
    // Back to settings whose whole run is known: that is shown.
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(state().previewing()) << "a whole run has come";
    set_modulus(5.0e5);
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    ASSERT_TRUE(state().previewing());
    driver.workbench->execute(commands::Undo{});
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    EXPECT_EQ(state().shown_run(), state().run);
}

TEST_F(Preview, WaitsForJobsAndGoesWithTheTrial) {
    driver.click("task/run");
    driver.click("preview/on");
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    const auto first = state().preview.run;
    ASSERT_TRUE(first);
    driver.workbench->execute(commands::ChooseTrial{1});
    EXPECT_FALSE(state().previewing());
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    ASSERT_TRUE(state().simulated_trial());
    EXPECT_EQ(state().simulated_trial()->name, "pull_release");
    EXPECT_TRUE(first->trials[1].frames.empty());

    driver.backend->hold_diagnosis = true;
    driver.workbench->execute(commands::Diagnose{});
    set_modulus(3.0e5);
    for (int i = 0; i < 20; ++i) driver.frame();
    EXPECT_TRUE(state().preview.working);
    EXPECT_NE(commands::preview_text(state()).find("running"), std::string::npos);
    driver.backend->hold_diagnosis = false;
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    driver.workbench->execute(commands::SetTime{0.2});
    driver.settle();
    EXPECT_LT(height_off(3.0e5), 1e-6);
}

/// The window goes on drawing as long as something works, so that what it brings is seen without any input.
TEST_F(Preview, CountsAsWorkUntilItIsShown) {
    EXPECT_FALSE(state().works());
    driver.backend->step_delay_s = 0.001;
    driver.workbench->execute(commands::ChangePreview{true, 0.5});
    EXPECT_TRUE(state().works());
    while (state().works()) driver.frame();
    EXPECT_TRUE(state().previewing());
}

TEST_F(Preview, PlaysAgainAndAgainAsFarAsItGoes) {
    driver.workbench->execute(commands::ChangePreview{true, 0.4});
    ASSERT_NO_FATAL_FAILURE(wait_for_preview());
    driver.workbench->execute(commands::SetTime{0.0});
    driver.workbench->execute(commands::Play{});
    for (int i = 0; i < 40; ++i) {
        driver.frame(0.05);
        EXPECT_LE(state().time_s, 0.4);
    }
    EXPECT_TRUE(state().playing);
}

}  // namespace
}  // namespace myo::ui
