#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "measurement/trace_csv.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"

// Repairs of a recording in the window, which a calibration then uses.

namespace myo {
namespace {

using test::Driver;
using testing::HasSubstr;

/// Whether both tracks have the same samples and the same gaps.
bool same_track(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    return a.cols() == b.cols() && (a.array() == b.array() || (a.array().isNaN() && b.array().isNaN())).all();
}

/// The bundled beam in a recording of which two markers have each other's names from beginning to end, which nothing
/// but a person can know.
struct MistakenBeam {
    test::Folder folder;
    std::filesystem::path beam;
    Driver driver{backend::make_core_backend(), 1280, 1400};
    std::string trace;

    explicit MistakenBeam(const std::string& name) : folder(name), beam(test::beam_in(folder)) {
        const std::filesystem::path file = beam / "gravity_release.csv";
        measurement::Recording recording = *measurement::read_trace_csv(file);
        std::swap(recording.tracks[0], recording.tracks[2]);
        EXPECT_TRUE(measurement::write_trace_csv(file, recording));
        trace = *read_file(file);
        driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
        EXPECT_TRUE(driver.wait_for_job(60));
        ui::commands::Settings coarse = driver.state().settings;
        coarse.resolution_m = 0.02;
        driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
        driver.workbench->execute(ui::commands::BuildMesh{});
        EXPECT_TRUE(driver.wait_for_job(60));
        driver.window->show_panel("markers");
        driver.settle();
    }
    /// Error of the shown trial after a calibration [m].
    double fitted_rms_m() {
        driver.workbench->execute(ui::commands::Calibrate{});
        EXPECT_TRUE(driver.wait_for_job(300));
        EXPECT_TRUE(driver.state().found) << driver.state().log.back().text;
        return driver.state().found ? driver.state().run->trials[0].rms_m : -1.0;
    }
    void type(const std::string& item, const std::string& text) {
        driver.double_click(item);
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
        driver.key(ImGuiKey_Enter);
    }
};

TEST(RepairInWindow, ASwapIsUsedByTheCalibrationAndUndone) {
    MistakenBeam mistaken("repair_swap");
    Driver& driver = mistaken.driver;
    const double wrong = mistaken.fitted_rms_m();
    EXPECT_GT(wrong, 3e-3);
    const ui::commands::SceneTrial before = driver.state().scene->trials[0];
    driver.click("repair/open");
    driver.click("repair/whole");
    driver.click("repair/with");
    driver.click("repair/with/2");
    driver.click("repair/swap");
    ASSERT_EQ(driver.state().refused, "");
    const ui::commands::SceneTrial& after = driver.state().scene->trials[0];
    ASSERT_EQ(after.repairs.made.size(), 1u);
    EXPECT_THAT(after.repairs.made[0], HasSubstr("swapped \"tip_left\" and \"tip_top\" from 0 s"));
    EXPECT_TRUE(same_track(after.measured[0], before.measured[2]));
    EXPECT_TRUE(same_track(after.measured[2], before.measured[0]));
    EXPECT_THAT(driver.state().scene->warnings, testing::Contains(HasSubstr("trial[0].repair[0]: repaired by hand")));
    driver.key(ImGuiKey_Escape);
    EXPECT_LT(mistaken.fitted_rms_m(), 0.3 * wrong);
    EXPECT_EQ(*read_file(mistaken.beam / "gravity_release.csv"), mistaken.trace) << "the recording never changes";
    // The calibration's values are a step of their own.
    driver.workbench->execute(ui::commands::Undo{});
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->trials[0].repairs.made.empty());
    EXPECT_TRUE(same_track(driver.state().scene->trials[0].measured[0], before.measured[0]));
}

TEST(RepairInWindow, CutThenFillThenRemovedAndARefusalIsTold) {
    MistakenBeam mistaken("repair_fill");
    Driver& driver = mistaken.driver;
    const ui::commands::SceneTrial before = driver.state().scene->trials[0];
    driver.click("repair/open");
    mistaken.type("repair/from", "0.2");
    mistaken.type("repair/to", "0.22");
    driver.click("repair/fill");
    EXPECT_THAT(driver.state().refused, HasSubstr("\"tip_left\" has no gap from 0.2 s to 0.22 s"));
    EXPECT_TRUE(driver.state().scene->trials[0].repairs.made.empty());
    driver.click("repair/cut");
    EXPECT_EQ(driver.state().refused, "");
    EXPECT_TRUE(driver.state().scene->trials[0].measured[0].col(21).array().isNaN().all());
    driver.click("repair/fill");
    const Eigen::Matrix3Xd filled = driver.state().scene->trials[0].measured[0];
    EXPECT_LT((filled - before.measured[0]).middleCols(20, 3).colwise().norm().maxCoeff(), 2e-3);
    ASSERT_EQ(driver.state().scene->trials[0].repairs.made.size(), 2u);
    // Without the cut there is nothing to fill, so only the last one can go.
    driver.click("repair/remove/1");
    EXPECT_EQ(driver.state().scene->trials[0].repairs.made.size(), 1u);
    driver.click("repair/remove/0");
    EXPECT_TRUE(same_track(driver.state().scene->trials[0].measured[0], before.measured[0]));
    driver.workbench->execute(ui::commands::Undo{});
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(same_track(driver.state().scene->trials[0].measured[0], filled));
    driver.workbench->execute(ui::commands::SaveDeclaration{});
    EXPECT_THAT(*read_file(mistaken.beam / "experiment.toml"), HasSubstr("[[trial.repair]]\nkind = \"cut\""));
}

}  // namespace
}  // namespace myo
