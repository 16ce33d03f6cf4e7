#include <gtest/gtest.h>

#include <algorithm>

#include "ui/driver.hpp"

// Messages that keep their place, and the order in which Escape closes things.

namespace myo::ui {
namespace {

using test::Driver;

TEST(Messages, NothingMovesWhenOneAppears) {
    Driver driver(1280, 1400);
    driver.backend->as_experiment = true;
    driver.open_beam();
    driver.click("task/material");
    const float before = driver.item("model/density").lowest.y;
    // An edit that is refused.
    driver.workbench->execute(
        commands::EditDeclaration{{commands::SetDeclared{{"gravity", "acceleration_m_s2"}, "refused"}}, "test", false});
    driver.settle();
    ASSERT_FALSE(driver.state().refused.empty());
    EXPECT_TRUE(driver.has("task/refused"));
    EXPECT_EQ(driver.item("model/density").lowest.y, before);
    // A task whose state gets many words.
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa *= 1.5;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.settle();
    EXPECT_EQ(driver.item("model/density").lowest.y, before);
}

TEST(Messages, AnOutdatedRunLeavesItsNumbersWhereTheyAre) {
    Driver driver(1280, 1400);
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.click("task/run");
    const float before = driver.item("run/trial/gravity_release").lowest.y;
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa *= 1.5;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.settle();
    EXPECT_EQ(driver.item("run/trial/gravity_release").lowest.y, before);
}

TEST(Escape, ClosesAListBeforeItsDialog) {
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_k, {.ctrl = true});
    driver.type("save picture");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    driver.click("picture/size");
    ASSERT_TRUE(driver.has("picture/size/other"));
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("picture/size/other"));
    EXPECT_TRUE(driver.has("picture/cancel"));
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("picture/cancel"));
}

TEST(Escape, ClosesAMenuBeforeItEndsATool) {
    Driver driver;
    driver.open_beam();
    driver.key(platform::key_d);
    ASSERT_TRUE(driver.window->viewport().measuring);
    driver.click("menu/view");
    ASSERT_TRUE(driver.has("menu/view.theme"));
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("menu/view.theme"));
    EXPECT_TRUE(driver.window->viewport().measuring);
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.window->viewport().measuring);
}

TEST(Escape, PutsTheBrushAway) {
    Driver driver;
    driver.open_beam();
    driver.click("task/fibres");
    driver.click("fibres/add");
    commands::BrushSettings brush = driver.state().brush;
    brush.tool = commands::BrushTool::add;
    driver.workbench->execute(commands::ChangeBrush{brush});
    driver.settle();
    driver.key(ImGuiKey_Escape);
    EXPECT_EQ(driver.state().brush.tool, commands::BrushTool::none);
}

TEST(Escape, IsTheCancelOfAQuestion) {
    Driver driver;
    driver.window->open("/body.stl");
    driver.settle();
    ASSERT_TRUE(driver.has("unit/mm"));
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("unit/mm"));
    EXPECT_FALSE(driver.state().unit_question);
    EXPECT_FALSE(driver.state().busy());
}

TEST(Keys, ArrowsAndEnterChooseFromAList) {
    Driver driver;
    driver.open_beam();
    const std::string before = driver.state().settings.integrator;
    driver.click("task/run");
    driver.click("model/integrator");
    driver.key(ImGuiKey_DownArrow);
    const double time_s = driver.state().time_s;
    driver.key(ImGuiKey_Space);
    driver.settle();
    EXPECT_NE(driver.state().settings.integrator, before);
    EXPECT_EQ(driver.state().time_s, time_s);
}

TEST(TwoWindows, TheSecondIsToldAndDoesNotOverwrite) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(commands::SaveAs{"/robot.myoloop"});
    driver.backend->open_elsewhere["/robot.myoloop"] = "robot.myoloop is open in another window of Myoloop, process 7";
    driver.window->open("/robot.myoloop");
    ASSERT_TRUE(driver.wait_for_job());
    const auto& log = driver.state().log;
    const auto told = [&](commands::LogLevel level) {
        return std::any_of(log.begin(), log.end(), [&](const commands::LogLine& line) {
            return line.level == level && line.text.find("open in another window") != std::string::npos;
        });
    };
    EXPECT_TRUE(told(commands::LogLevel::warning));
    driver.backend->projects.clear();
    driver.workbench->execute(commands::Save{});
    EXPECT_TRUE(told(commands::LogLevel::failure));
    EXPECT_EQ(driver.backend->projects.count("/robot.myoloop"), 0u);
    driver.workbench->execute(commands::SaveAs{"/other.myoloop"});
    EXPECT_EQ(driver.backend->projects.count("/other.myoloop"), 1u);
    driver.backend->open_elsewhere.clear();
    driver.workbench->execute(commands::SaveAs{"/robot.myoloop"});
    EXPECT_EQ(driver.backend->projects.count("/robot.myoloop"), 1u);
}

TEST(Ticks, AStoppedSearchHasNone) {
    Driver driver;
    driver.open_beam();
    driver.click("run/calibrate");
    ASSERT_TRUE(driver.wait_for_job());
    commands::WorkbenchState state = driver.state();
    EXPECT_EQ(commands::task_status(state, commands::Task::fit).checks, commands::CheckState::green);
    const auto status_of = [&](const auto& change) {
        commands::SearchResult found = *driver.state().found;
        change(found);
        state.found = std::make_shared<const commands::SearchResult>(found);
        return commands::task_status(state, commands::Task::fit);
    };
    const commands::TaskStatus stopped = status_of([](commands::SearchResult& found) { found.stopped = true; });
    EXPECT_EQ(stopped.checks, commands::CheckState::amber);
    EXPECT_NE(stopped.next.find("Cancelled before its end"), std::string::npos);
    const commands::TaskStatus failed = status_of(
        [](commands::SearchResult& found) { found.problem = "The fit did not converge: x."; });
    EXPECT_EQ(failed.checks, commands::CheckState::amber);
    EXPECT_NE(failed.next.find("did not converge"), std::string::npos);
    EXPECT_EQ(status_of([](commands::SearchResult& found) { found.rms_after_m = 2.0 * found.rms_before_m; }).checks,
              commands::CheckState::amber);
}

TEST(Ticks, ALargeResidualTakesThatOfTheComparisonAndSaysWhy) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    commands::WorkbenchState state = driver.state();
    commands::RunResult run = *state.run;
    commands::CheckRow residual;
    residual.id = "residual";
    residual.state = commands::CheckState::amber;
    residual.sentence = "the residual is 5 times the noise";
    residual.way_out = "suspected, in this order: the direction of gravity";
    residual.task = "fit";
    run.checks.push_back(residual);
    state.run = std::make_shared<const commands::RunResult>(run);
    EXPECT_EQ(commands::task_status(state, commands::Task::run).checks, commands::CheckState::green);
    const commands::TaskStatus measure = commands::task_status(state, commands::Task::measure);
    EXPECT_EQ(measure.checks, commands::CheckState::amber);
    EXPECT_NE(
        measure.next.find("The residual is 5 times the noise. Suspected, in this order: the direction of gravity."),
        std::string::npos)
        << measure.next;
}

}  // namespace
}  // namespace myo::ui
