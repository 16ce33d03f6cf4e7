#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/arm.hpp"

// From a planned trial with a muscle to a goal that is reached, in the window.

namespace myo {
namespace {

using test::arm_toml;
using test::Driver;
using testing::HasSubstr;

TEST(GoalInWindow, IsAddedMovedReachedAndUndone) {
    const test::Folder folder("goal_in_window");
    folder.write("arm/experiment.toml", arm_toml);
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(folder.path() / "arm");
    ASSERT_TRUE(driver.wait_for_job(60));
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.01;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    // Optimise has nothing to follow yet.
    driver.window->show_panel("goal");
    driver.settle();
    EXPECT_FALSE(driver.has("fit/optimize"));
    driver.workbench->execute(ui::commands::SetTime{0.3});
    driver.settle();
    driver.click("goal/add");
    ASSERT_EQ(driver.state().scene_trial()->goals.size(), 1u) << driver.state().refused;
    const ui::commands::SceneGoal added = driver.state().scene_trial()->goals[0];
    EXPECT_NEAR(added.time_s(0), 0.3, 1e-9);
    ASSERT_TRUE(driver.state().run) << "the shown run stays";
    const Eigen::Matrix3Xd rest = driver.state().simulated_trial()->markers[0];
    EXPECT_LT((added.place_m.col(0) - rest.rightCols<1>()).norm(), 1e-4) << "where the marker rests under its weight";

    // The goal is dragged upwards in the view.
    const ImVec2 from = test::pixel_of(driver, added.place_m.col(0));
    driver.drag(from, {from.x, from.y - 20.0f});
    const Eigen::Vector3d goal = driver.state().scene_trial()->goals[0].place_m.col(0);
    EXPECT_GT((goal - added.place_m.col(0)).norm(), 1e-4) << driver.state().refused;
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_LT((driver.state().scene_trial()->goals[0].place_m - added.place_m).norm(), 1e-12) << "one step";
    // To a place that the muscle can reach: 3 mm higher.
    const Eigen::Vector3d higher = added.place_m.col(0) + Eigen::Vector3d(0.0, 0.0, 0.003);
    driver.workbench->execute(ui::commands::EditDeclaration{
        {ui::commands::SetDeclared{{"trial", std::size_t{0}, "goal", std::size_t{0}, "place_m"},
                                   "[" + std::to_string(higher.x()) + ", " + std::to_string(higher.y()) + ", " +
                                       std::to_string(higher.z()) + "]"},
         ui::commands::SetDeclared{{"trial", std::size_t{0}, "goal", std::size_t{0}, "axes"}, "[\"z\"]"}},
        "goal"});
    ASSERT_NEAR(driver.state().scene_trial()->goals[0].place_m(2, 0), higher.z(), 1e-5) << driver.state().refused;

    driver.settle();
    const ui::commands::Settings before = driver.state().settings;
    driver.click("fit/optimize");
    ASSERT_TRUE(driver.wait_for_job(240));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    const ui::commands::SearchResult& found = *driver.state().found;
    EXPECT_NEAR(found.rms_before_m, 0.003, 3e-4);
    EXPECT_LT(found.rms_after_m, 3e-4) << "reached";
    ASSERT_TRUE(driver.state().search);
    EXPECT_EQ(driver.state().search->target, "goals of trial reach");
    EXPECT_THAT(found.notes.front(), HasSubstr("follow the goals of reach"));
    // The shown run is that with the signals found: the marker is at its goal, and the signal stays after it.
    const Eigen::VectorXd& times = driver.state().scene_trial()->time_s;
    Eigen::Index sample = 0;
    (times.array() - 0.3).abs().minCoeff(&sample);
    EXPECT_NEAR(driver.state().simulated_trial()->markers[0](2, sample), higher.z(), 3e-4);
    const fibre::Signal& signal = *driver.state().settings.muscles[0].signal;
    EXPECT_EQ(signal.value(0.4), signal.values.back());
    EXPECT_LT(signal.value(0.4), 1.0 - 0.3 * (1.0 - *std::min_element(signal.values.begin(), signal.values.end())));
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().settings, before) << "the result is one edit";
    EXPECT_EQ(*read_file(folder.path() / "arm/experiment.toml"), arm_toml) << "the file is written on request only";
}

/// A single place becomes a path by points at shown times, and a place again when they are removed.
TEST(GoalInWindow, BecomesAPathByPoints) {
    const test::Folder folder("goal_path_in_window");
    folder.write("arm/experiment.toml", arm_toml +
                                            "[[trial.goal]]\nmarker = \"tip\"\ntime_s = 0.3\nplace_m = [0.08, "
                                            "0.01, 0.023]\n");
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(folder.path() / "arm");
    ASSERT_TRUE(driver.wait_for_job(60)) << driver.state().log.back().text;
    const auto goal = [&]() -> const ui::commands::SceneGoal& { return driver.state().scene_trial()->goals.at(0); };
    driver.window->show_panel("goal");
    driver.workbench->execute(ui::commands::SetTime{0.1});
    driver.settle();
    ASSERT_FALSE(goal().is_path);
    driver.click("goal/0/point");
    ASSERT_TRUE(goal().is_path) << driver.state().refused;
    ASSERT_EQ(goal().time_s.size(), 2);
    EXPECT_NEAR(goal().time_s(0), 0.1, 1e-9);
    EXPECT_NEAR(goal().place_m(2, 0), 0.023, 1e-9) << "on the path as it was";
    driver.workbench->execute(ui::commands::SetTime{0.2});
    driver.settle();
    driver.click("goal/0/point");
    ASSERT_EQ(goal().time_s.size(), 3);
    EXPECT_NEAR(goal().time_s(1), 0.2, 1e-9);
    driver.settle();
    driver.click("goal/0/point_removed");
    ASSERT_EQ(goal().time_s.size(), 2);
    driver.workbench->execute(ui::commands::SetTime{0.1});
    driver.settle();
    driver.click("goal/0/point_removed");
    EXPECT_FALSE(goal().is_path) << driver.state().refused;
    EXPECT_NEAR(goal().time_s(0), 0.3, 1e-9);

    // One coordinate may be left free; all three are not written.
    using Axes = std::array<bool, 3>;
    EXPECT_EQ(goal().axes, (Axes{true, true, true}));
    driver.click("goal/0/along/y");
    EXPECT_EQ(goal().axes, (Axes{true, false, true})) << driver.state().refused;
    driver.click("goal/0/along/y");
    EXPECT_EQ(goal().axes, (Axes{true, true, true}));
    for (int step = 0; step < 6; ++step) driver.workbench->execute(ui::commands::Undo{});
    EXPECT_FALSE(driver.state().settings.declaration.text) << "each edit was one step";
}

}  // namespace
}  // namespace myo
