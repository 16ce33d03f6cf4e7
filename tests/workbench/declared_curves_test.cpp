#include <gtest/gtest.h>

#include "workbench/by_hand.hpp"
#include "workbench/example_copy.hpp"
#include "workbench/opened_beam.hpp"

// Curves over time, and bounds of unknown values, edited in rows.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;
using ui::commands::Undo;

TEST(LoadCurveInWindow, AForceIsGivenAWindowAndThenACurve) {
    OpenedBeam beam("load_curve");
    Driver& driver = beam.driver;
    driver.window->show_panel("trial");
    driver.settle();
    driver.click("trial/add");
    driver.settle();
    driver.click("trial/add_force");
    driver.settle();
    const auto load = [&]() { return driver.state().scene_trial()->loads[0]; };
    driver.click("trial/load/0/when");
    driver.click("trial/load/0/when/window");
    driver.settle();
    EXPECT_EQ(load().from_s, 0.0) << driver.state().refused;
    EXPECT_EQ(load().until_s, 0.5);
    test::type_into(driver, "trial/load/0/until", "200 ms");
    EXPECT_NEAR(load().until_s, 0.2, 1e-12);
    driver.click("trial/load/0/when");
    driver.click("trial/load/0/when/curve");
    driver.settle();
    ASSERT_TRUE(load().curve) << driver.state().refused;
    EXPECT_TRUE(std::isinf(load().until_s));
    test::type_into(driver, "trial/load/0/curve/1/value", "-2");
    EXPECT_EQ(load().curve->values, (std::vector<double>{0.0, -2.0}));
    driver.click("trial/load/0/curve/add");
    driver.settle();
    EXPECT_EQ(load().curve->times_s, (std::vector<double>{0.0, 0.5, 1.0}));
    driver.workbench->execute(Undo{});
    EXPECT_EQ(load().curve->times_s.size(), 2u);
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const double pushed_up = beam.last_height_m();
    driver.window->show_panel("trial");
    driver.settle();
    driver.click("trial/load/0/when");
    driver.click("trial/load/0/when/constant");
    EXPECT_FALSE(load().curve);
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_LT(beam.last_height_m(), pushed_up - 0.002);
}

TEST(CommandCurveInWindow, ThePressureOfAChamberFollowsRows) {
    Driver driver(backend::make_core_backend(), 1280, 1400);
    const test::Folder folder("command_curve");
    driver.window->open(test::example_copy(folder, "pneumatic_finger"));
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    const std::string name = driver.state().scene->declared.chambers.at(0), item = "chamber/" + name + "/pressure";
    driver.window->show_panel("chamber");
    driver.settle();
    driver.click(item + "/kind");
    driver.click(item + "/kind/curve");
    driver.settle();
    const auto command = [&]() {
        return driver.state().scene->declared.commands[static_cast<std::size_t>(driver.state().trial)].at(name);
    };
    ASSERT_EQ(command().kind, ui::commands::DeclaredCommand::Kind::curve) << driver.state().refused;
    ASSERT_EQ(command().curve.times_s.size(), 2u);
    test::type_into(driver, item + "/curve/1/value", "12 kPa");
    EXPECT_NEAR(command().curve.values[1], 12e3, 1e-9);
    EXPECT_NEAR(driver.state().scene_trial()->commands.at(name).signal.value(0.25), 6e3, 1e-6)
        << "what runs and what the signals show";
    driver.workbench->execute(Undo{});
    driver.workbench->execute(Undo{});
    EXPECT_NE(command().kind, ui::commands::DeclaredCommand::Kind::curve);
}

/// A recording is used up to a time of the trial, which is declared as one of the recording.
TEST(RecordingInWindow, EndsEarlierByANumber) {
    OpenedBeam beam("recording_end");
    Driver& driver = beam.driver;
    const auto last_s = [&] { return driver.state().scene->trials[0].time_s.tail(1)(0); };
    const double whole_s = last_s(), other_s = driver.state().scene->trials[1].time_s.tail(1)(0);
    ASSERT_GT(whole_s, 0.3);
    driver.window->show_panel("trial");
    driver.settle();
    test::type_into(driver, "trial/end", "0.2 s");
    EXPECT_LE(last_s(), 0.2 + 1e-9) << driver.state().refused;
    EXPECT_GT(last_s(), 0.15);
    EXPECT_EQ(driver.state().scene->trials[1].time_s.tail(1)(0), other_s) << "other trials keep theirs";
    driver.settle();
    test::type_into(driver, "trial/end", "100 s");
    EXPECT_EQ(last_s(), whole_s) << "all of it";
    for (int step = 0; step < 2; ++step) driver.workbench->execute(Undo{});
    EXPECT_EQ(last_s(), whole_s);
    EXPECT_FALSE(driver.state().settings.declaration.text);
}

TEST(BoundsInWindow, AValueGetsBoundsAndATolerance) {
    OpenedBeam beam("bounds");
    Driver& driver = beam.driver;
    const auto modulus = [&]() { return driver.state().scene->fitted.at(0); };
    ASSERT_EQ(modulus().name, "youngs_modulus_Pa");
    const double usual = modulus().highest;
    driver.window->show_panel("unknown");
    driver.settle();
    const std::string item = "unknown/bounds/youngs_modulus_Pa";
    EXPECT_FALSE(driver.has(item + "/kind")) << "a row per value until it is opened";
    driver.click(item);
    driver.settle();
    driver.click(item + "/kind");
    driver.click(item + "/kind/bounds");
    driver.settle();
    ASSERT_TRUE(modulus().declared_highest) << driver.state().refused;
    EXPECT_NEAR(modulus().highest, usual, 1e-6 * usual) << "begins with the usual bounds";
    test::type_into(driver, item + "/highest", "1 MPa");
    EXPECT_NEAR(modulus().highest, 1e6, 1e-6);
    driver.click(item + "/kind");
    driver.click(item + "/kind/tolerance");
    driver.settle();
    ASSERT_TRUE(modulus().declared_tolerance) << driver.state().refused;
    test::type_into(driver, item + "/tolerance", "20 kPa");
    EXPECT_NEAR(modulus().highest - modulus().lowest, 40e3, 1e-3);
    driver.click(item + "/kind");
    driver.click(item + "/kind/usual");
    driver.settle();
    EXPECT_EQ(modulus().declared, -1);
    EXPECT_NEAR(modulus().highest, usual, 1e-6 * usual);
}

}  // namespace
}  // namespace myo
