#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "backend/workbench_backend.hpp"
#include "base/stopwatch.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

/// What is promised of every job, on a machine that does little else.
constexpr double max_s = 1.0;

/// Bundled examples on the real core, jobs cancelled at several moments of their lives.
class Cancel : public ::testing::Test {
protected:
    Driver driver{backend::make_core_backend(), 1000, 700};

    void open(const std::string& example) {
        driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/" + example);
        ASSERT_TRUE(driver.wait_for_job(60));
        ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    }
    void choose(double resolution_m, mesh::CellType element) {
        ui::commands::Settings settings = driver.state().settings;
        settings.resolution_m = resolution_m;
        settings.element = element;
        driver.workbench->execute(ui::commands::ChangeSettings{settings, "mesh"});
    }
    void mesh() {
        driver.workbench->execute(ui::commands::BuildMesh{});
        ASSERT_TRUE(driver.wait_for_job(120));
        ASSERT_TRUE(driver.state().mesh_is_current()) << driver.state().log.back().text;
    }
    /// Starts a job, cancels it after a while and asserts that it ends soon after. Jobs that have ended by then have
    /// nothing to show.
    void expect_soon(const ui::commands::Command& start, double after_s) {
        SCOPED_TRACE("cancelled after " + std::to_string(after_s) + " s");
        driver.workbench->execute(start);
        const Stopwatch since;
        while (driver.state().busy() && since.seconds() < after_s) step();
        if (driver.state().busy()) expect_soon_cancelled();
    }
    void expect_soon_cancelled() {
        const std::string stage = driver.state().job->name + ", " + driver.state().job->progress.task;
        driver.workbench->execute(ui::commands::Cancel{});
        const Stopwatch watch;
        while (driver.state().busy() && watch.seconds() < 60.0) step();
        EXPECT_LT(watch.seconds(), max_s) << stage;
        ++cancelled;
    }
    void step() {
        driver.workbench->advance(0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    int cancelled = 0;
};

TEST_F(Cancel, EndsARun) {
    ASSERT_NO_FATAL_FAILURE(open("silicone_beam"));
    choose(0.004, mesh::CellType::hex8);
    ASSERT_NO_FATAL_FAILURE(mesh());
    for (const double after_s : {0.0, 0.1, 0.5}) expect_soon(ui::commands::Run{}, after_s);
    EXPECT_GE(cancelled, 2);
}

TEST_F(Cancel, EndsACalibration) {
    ASSERT_NO_FATAL_FAILURE(open("silicone_beam"));
    choose(0.006, mesh::CellType::hex8);
    ASSERT_NO_FATAL_FAILURE(mesh());
    for (const double after_s : {0.2, 2.0}) expect_soon(ui::commands::Calibrate{}, after_s);
    EXPECT_GE(cancelled, 2);
}

TEST_F(Cancel, EndsASearchForSignals) {
    ASSERT_NO_FATAL_FAILURE(open("soft_arm"));
    for (const double after_s : {0.3, 2.0, 5.0}) expect_soon(ui::commands::Optimize{}, after_s);
    EXPECT_GE(cancelled, 2);
}

/// So fine that a run takes seconds: none is made once the search is cancelled, and what is known of its best signals
/// is kept.
TEST_F(Cancel, LeavesNoRunToWaitForAfterASearch) {
    ASSERT_NO_FATAL_FAILURE(open("soft_arm"));
    choose(0.65 * driver.state().settings.resolution_m, driver.state().settings.element);
    ASSERT_NO_FATAL_FAILURE(mesh());
    driver.workbench->execute(ui::commands::Optimize{});
    const Stopwatch since;
    while (driver.state().busy() && !(driver.state().search && !driver.state().search->log.empty()) &&
           since.seconds() < 120.0)
        step();
    ASSERT_TRUE(driver.state().searching() && driver.state().search);
    expect_soon_cancelled();
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    EXPECT_TRUE(driver.state().found->stopped);
    EXPECT_TRUE(driver.state().run_is_current());
    EXPECT_TRUE(driver.state().simulated_trial()->markers.front().allFinite());
}

TEST_F(Cancel, EndsADiagnosis) {
    ASSERT_NO_FATAL_FAILURE(open("silicone_beam"));
    choose(0.006, mesh::CellType::hex8);
    ASSERT_NO_FATAL_FAILURE(mesh());
    for (const double after_s : {0.5, 2.0, 4.0, 7.0}) expect_soon(ui::commands::Diagnose{}, after_s);
    EXPECT_GE(cancelled, 2);
}

TEST_F(Cancel, EndsTetrahedralMeshing) {
    ASSERT_NO_FATAL_FAILURE(open("silicone_beam"));
    choose(0.0012, mesh::CellType::tet10);
    for (const double after_s : {0.1, 1.0, 3.0}) expect_soon(ui::commands::BuildMesh{}, after_s);
    EXPECT_GE(cancelled, 2);
}

/// A fine mesh of bricks is made at once; what takes time is what is worked out of it.
TEST_F(Cancel, EndsTheWorkAfterAFineMesh) {
    ASSERT_NO_FATAL_FAILURE(open("silicone_beam"));
    choose(0.001, mesh::CellType::hex8);
    for (const double after_s : {0.05, 0.2, 0.4, 0.8}) expect_soon(ui::commands::BuildMesh{}, after_s);
    EXPECT_GE(cancelled, 1);
}

}  // namespace
}  // namespace myo
