#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ui/driver.hpp"

// Playing live in the window, on a backend that moves by a closed form.

namespace myo {
namespace {

using test::Driver;
using testing::HasSubstr;
using ui::commands::ChangeSettings;

/// Draws frames until a condition holds, at most two seconds.
template <class Condition>
bool soon(Driver& driver, const Condition& condition) {
    for (int frame = 0; frame < 200; ++frame) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        driver.frame(0.01);
    }
    return false;
}

/// The beam, playing live.
struct PlayingBeam {
    Driver driver{1280, 1400};

    PlayingBeam() {
        driver.open_beam();
        driver.window->show_panel("live");
        driver.settle();
        driver.click("live/play");
        EXPECT_TRUE(soon(driver, [&] { return live() && live()->ready; }));
    }
    const ui::commands::LiveView* live() { return driver.state().live ? &*driver.state().live : nullptr; }
    /// A drag on the body from its free end, with frames between; `held`: looks before the button is released.
    template <class Look>
    void pull(const Look& held) {
        const Eigen::Vector3d tip = live()->frame->markers_m.front();
        const ImVec2 from = test::pixel_of(driver, tip), to{from.x, from.y - 80.0f};
        ui::platform::InputQueue& input = driver.window->input();
        for (const ui::platform::InputEvent& event : std::vector<ui::platform::InputEvent>{
                 ui::platform::MouseMoved{from.x, from.y}, ui::platform::MouseButton{0, true, {}},
                 ui::platform::MouseMoved{to.x, to.y}}) {
            input.push(event);
            driver.frame();
        }
        held();
        input.push(ui::platform::MouseButton{0, false, {}});
        driver.settle();
    }
};

TEST(PlayLive, TheModelMovesInRealTimeAndTheRecordedRunStays) {
    PlayingBeam beam;
    Driver& driver = beam.driver;
    const auto recorded = driver.state().run;
    const double shown_s = driver.state().time_s;
    const double from_s = beam.live()->frame->time_s;
    const auto began = std::chrono::steady_clock::now();
    ASSERT_TRUE(soon(driver, [&] { return beam.live()->frame->time_s > from_s + 0.3; }));
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    EXPECT_GT(passed, 0.25) << "faster than real time";
    const Eigen::Matrix3Xd drawn = driver.window->scene().positions;
    EXPECT_TRUE(soon(driver, [&] { return driver.window->scene().positions != drawn; }));
    EXPECT_EQ(driver.state().run, recorded);
    driver.click("live/play");
    EXPECT_FALSE(driver.state().live);
    EXPECT_EQ(driver.state().run, recorded);
    EXPECT_EQ(driver.state().time_s, shown_s);
}

TEST(PlayLive, ASliderMovesTheModelAtOnce) {
    PlayingBeam beam;
    ui::commands::LiveControls controls = beam.live()->controls;
    ASSERT_EQ(controls.levels.size(), 1u);
    const auto began = std::chrono::steady_clock::now();
    controls.levels = {0.03};
    beam.driver.workbench->execute(ui::commands::SteerLive{controls});
    const auto lifted = [&] { return beam.driver.window->scene().positions.row(2).minCoeff() > 0.015; };
    ASSERT_TRUE(soon(beam.driver, lifted));
    // A machine that runs other tests beside this one may take longer than a person would see.
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(), 1.0);
    EXPECT_TRUE(beam.driver.has("live/level/lift/slider"));
}

TEST(PlayLive, ADragOnTheBodyPullsItAndShowsTheForce) {
    PlayingBeam beam;
    beam.pull([&] {
        ASSERT_TRUE(soon(beam.driver, [&] { return beam.live()->frame->force_N > 0.05; }));
        EXPECT_TRUE(beam.driver.has("view/live_force"));
        EXPECT_TRUE(beam.live()->controls.grip);
    });
    EXPECT_TRUE(soon(beam.driver, [&] { return !beam.live()->controls.grip; }));
    EXPECT_FALSE(beam.driver.has("view/live_force"));
}

TEST(PlayLive, StepAndVelocityForceFollowTheSettingsAndAMaterialMakesANewModel) {
    PlayingBeam beam;
    Driver& driver = beam.driver;
    EXPECT_EQ(driver.backend->live_models, 1);
    ui::commands::Settings settings = driver.state().settings;
    settings.velocity_force_1_s = 0.7;
    settings.time_step_s = 0.004;
    driver.workbench->execute(ChangeSettings{settings, "force"});
    EXPECT_TRUE(soon(driver, [&] { return driver.backend->live_velocity_force == 0.7; }));
    EXPECT_TRUE(soon(driver, [&] { return beam.live()->frame->step_s == 0.004; }));
    EXPECT_EQ(driver.backend->live_models, 1);
    settings.youngs_modulus_Pa *= 2.0;
    driver.workbench->execute(ChangeSettings{settings, "modulus"});
    EXPECT_TRUE(soon(driver, [&] { return driver.backend->live_models == 2; }));
    EXPECT_TRUE(beam.live());
}

TEST(PlayLive, BehindRealTimeItTakesLongerStepsAndSaysSo) {
    PlayingBeam beam;
    beam.driver.backend->step_delay_s = 0.03;
    EXPECT_TRUE(soon(beam.driver, [&] {
        return beam.live()->frame->step_s == ui::commands::live_play_policy.longest_step_s && beam.live()->rate > 0.0 &&
               beam.live()->rate < ui::commands::live_play_policy.behind_below;
    }));
}

TEST(PlayLive, WhatCannotBeSolvedIsSaidAndItGoesOn) {
    PlayingBeam beam;
    ui::commands::LiveControls controls = beam.live()->controls;
    controls.levels = {0.045};
    beam.driver.workbench->execute(ui::commands::SteerLive{controls});
    EXPECT_TRUE(soon(beam.driver, [&] { return !beam.live()->problem.empty(); }));
    EXPECT_THAT(beam.live()->problem, HasSubstr("too high"));
    controls.levels = {0.01};
    beam.driver.workbench->execute(ui::commands::SteerLive{controls});
    EXPECT_TRUE(soon(beam.driver, [&] { return beam.live()->problem.empty(); }));
}

TEST(PlayLive, StandsStillWhileTheModelOfTheSettingsCannotBeMade) {
    PlayingBeam beam;
    ui::commands::Settings settings = beam.driver.state().settings;
    beam.driver.backend->refuses_live = true;
    settings.youngs_modulus_Pa *= 2.0;
    beam.driver.workbench->execute(ChangeSettings{settings, "modulus"});
    ASSERT_TRUE(soon(beam.driver, [&] { return !beam.live()->problem.empty(); }));
    const double stopped_s = beam.live()->frame->time_s;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    beam.driver.frame(0.1);
    EXPECT_THAT(beam.live()->problem, HasSubstr("cannot move"));
    EXPECT_EQ(beam.live()->frame->time_s, stopped_s) << "the model of other settings would be shown";
    beam.driver.backend->refuses_live = false;
    settings.youngs_modulus_Pa *= 1.1;
    beam.driver.workbench->execute(ChangeSettings{settings, "modulus"});
    EXPECT_TRUE(soon(beam.driver, [&] { return beam.live()->problem.empty(); }));
    const auto frame = beam.live()->frame;
    EXPECT_TRUE(soon(beam.driver, [&] { return beam.live()->frame != frame; }));
}

TEST(PlayLive, AnotherMeshEndsIt) {
    PlayingBeam beam;
    ui::commands::Settings settings = beam.driver.state().settings;
    settings.resolution_m *= 2.0;
    beam.driver.workbench->execute(ChangeSettings{settings, "resolution"});
    EXPECT_FALSE(beam.driver.state().live);
}

}  // namespace
}  // namespace myo
