#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "backend/workbench_backend.hpp"
#include "support/swung_beam.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

std::string with(std::string text, const std::string& old, const std::string& other) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), other);
}

/// Markers that swing about a sag of 20 mm, of a beam that is declared straight.
std::string sagging_trace() {
    const char* const names[] = {"tip_left", "tip_right", "tip_low", "middle"};
    const double rest[][3] = {{0.1, 0.0, 0.03}, {0.1, 0.03, 0.03}, {0.1, 0.015, 0.0}, {0.05, 0.015, 0.03}};
    std::string text = "time_s";
    for (const char* name : names)
        for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
    for (int k = 0; k <= 30; ++k) {
        const double t = 0.01 * k;
        text += "\n" + std::to_string(t);
        for (const auto& place : rest) {
            char point[96];
            const double z = place[2] - 0.02 - 0.004 * std::sin(45.0 * t);
            std::snprintf(point, sizeof point, ",%.6f,%.6f,%.6f", place[0], place[1], z);
            text += point;
        }
    }
    return text + "\n";
}

/// Opens the beam of a folder and gives it coarse cells.
void open_coarse(Driver& driver, const test::Folder& folder) {
    driver.window->open(folder.path());
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.015;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
}

const ui::commands::CheckRow* row_of(const ui::commands::WorkbenchState& state, const std::string& id) {
    const ui::commands::CheckRows& rows = state.checks->rows;
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const ui::commands::CheckRow& row) { return row.id == id; });
    return found != rows.end() ? &*found : nullptr;
}

TEST(CoreChecks, ABeamThatIsDeclaredStraightButSagsIsRedWhenItIsOpened) {
    const test::Folder folder("workbench_checks");
    static_cast<void>(test::swung_beam(folder, 0.3));
    folder.write("swing.csv", sagging_trace());
    Driver driver(backend::make_core_backend(), 1280, 800);
    ASSERT_NO_FATAL_FAILURE(open_coarse(driver, folder));
    ASSERT_TRUE(driver.state().checks);
    const ui::commands::CheckRow& worst = driver.state().checks->rows.front();
    EXPECT_EQ(worst.id, "start");
    EXPECT_EQ(worst.question, "Does the model begin where the recording begins?");
    EXPECT_EQ(worst.state, ui::commands::CheckState::red);
    EXPECT_EQ(worst.subject, "swing");
    EXPECT_EQ(worst.figure, "20.0 mm");
    EXPECT_NE(worst.threshold.find(" mm"), std::string::npos);
    EXPECT_NE(worst.way_out.find("equilibrium"), std::string::npos);
    EXPECT_FALSE(worst.source.empty());
    EXPECT_EQ(driver.state().checks->rows.back().state, ui::commands::CheckState::green);
    EXPECT_EQ(row_of(driver.state(), "units")->figure, "100 mm");
    driver.click("bar/checks");
    EXPECT_TRUE(driver.has("checks/row/0"));
    EXPECT_TRUE(driver.has("checks/stale")) << "coarser cells than those that were checked";
}

/// 26 times the stiffness: 37 Hz, of which ten steps of 2.5 ms make 1.9 % less.
TEST(CoreChecks, AStepThatAPersonMadeTooLongIsRedAndTheProgramsOwnIsNot) {
    const test::Folder folder("workbench_step");
    static_cast<void>(test::swung_beam(folder, 0.3));
    const std::string stiff = with(test::swung_beam_toml(), "2.6e5", "6.8e6");
    folder.write("experiment.toml", with(stiff, "damping_s = 0.004", "damping_s = 1e-4"));
    Driver driver(backend::make_core_backend(), 1280, 800);
    ASSERT_NO_FATAL_FAILURE(open_coarse(driver, folder));
    EXPECT_DOUBLE_EQ(driver.state().settings.time_step_s, 0.005) << "half the interval of the recording";
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().run_is_current()) << driver.state().log.back().text;
    EXPECT_LT(driver.state().settings.time_step_s, 1e-3);
    EXPECT_FALSE(driver.state().settings.own_step);
    EXPECT_NEAR(driver.state().run->trials[0].vibration_Hz, 37.0, 4.0);
    ASSERT_TRUE(row_of(driver.state(), "step"));
    EXPECT_EQ(row_of(driver.state(), "step")->state, ui::commands::CheckState::green);
    // The recording is of a beam that does not move: a run says so, and where values that fit are found.
    const ui::commands::CheckRow* const residual = row_of(driver.state(), "residual");
    ASSERT_TRUE(residual);
    EXPECT_NE(residual->state, ui::commands::CheckState::green);
    EXPECT_EQ(residual->task, "fit");

    ui::commands::Settings settings = driver.state().settings;
    settings.time_step_s = 2.5e-3;
    driver.workbench->execute(ui::commands::ChangeSettings{settings, "step"});
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_EQ(driver.state().settings.time_step_s, 2.5e-3);
    const ui::commands::CheckRow* const row = row_of(driver.state(), "step");
    ASSERT_TRUE(row);
    EXPECT_EQ(row->state, ui::commands::CheckState::red);
    EXPECT_EQ(row->figure.substr(row->figure.size() - 2), " %");
    // What the panel of the time step shows is what was found.
    const double omega = 2.0 * 3.14159265358979 * driver.state().run->trials[0].vibration_Hz;
    const ui::commands::StepQuality shown = driver.state().integrator()->step_quality(omega, driver.state().settings);
    EXPECT_EQ(shown.state, ui::commands::CheckState::red);
    EXPECT_NEAR(100.0 * shown.frequency_error, std::stod(row->figure), 0.051);
}

}  // namespace
}  // namespace myo
