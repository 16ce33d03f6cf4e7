#include <gtest/gtest.h>

#include <cmath>

#include "backend/examples.hpp"
#include "backend/workbench_backend.hpp"
#include "commands/scene_at_time.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

void scrub_to(Driver& driver, float fraction) {
    const ui::platform::Rectangle track = driver.item("timeline/track");
    driver.click_at({track.lowest.x + fraction * track.width(), track.center().y});
}

/// Asserts that each marker of a kind that is neither occluded nor on the far side is drawn where it projects; their
/// number.
int seen_markers(Driver& driver, bool simulated) {
    const ui::platform::Theme theme = ui::platform::make_theme(ui::platform::ThemeName::dark, 1.0f);
    const ui::platform::Image image = driver.picture();
    int count = 0;
    for (const ui::viewport::DrawnMarker& marker : driver.window->scene().markers) {
        if (marker.ring != simulated || !marker.position.allFinite() || marker.position.y() > 0.029) continue;
        ++count;
        EXPECT_TRUE(test::color_near(image, test::pixel_of(driver, marker.position),
                                     simulated ? theme.simulated : theme.measured, 12))
            << marker.label;
    }
    return count;
}

TEST(BundledExample, EachHasAPictureOfItsOwn) {
    const std::vector<ui::commands::Example> examples = backend::bundled_examples();
    ASSERT_GE(examples.size(), 2u);
    for (std::size_t a = 0; a < examples.size(); ++a) {
        EXPECT_FALSE(examples[a].picture.triangles.empty()) << examples[a].name;
        for (std::size_t b = 0; b < a; ++b) {
            const auto &one = examples[a].picture, &other = examples[b].picture;
            EXPECT_TRUE(one.width != other.width || one.height != other.height ||
                        one.triangles.size() != other.triangles.size())
                << examples[a].name << " and " << examples[b].name;
        }
    }
}

TEST(BundledExample, OpensRunsAndScrubs) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().scene->trials.size(), 3u);
    EXPECT_EQ(driver.state().scene->markers.size(), 5u);
    ASSERT_TRUE(driver.state().body);
    EXPECT_NEAR(mesh::cell_volumes(driver.state().body->mesh).sum(), 0.12 * 0.03 * 0.02, 1e-12);

    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(300));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    EXPECT_TRUE(driver.state().run_is_current());
    EXPECT_EQ(driver.state().run->trials.size(), 3u);
    // The declared modulus is a data sheet's: some millimetres off, and no more than the swing.
    EXPECT_GT(driver.state().run->rms_m, 1e-3);
    EXPECT_LT(driver.state().run->rms_m, 2e-2);

    // At rest the measured markers lie on the body; later some may be inside it, for the declared modulus is wrong.
    scrub_to(driver, 0.0f);
    EXPECT_GE(seen_markers(driver, false), 3);
    scrub_to(driver, 0.2f);
    const double early = driver.state().time_s;
    EXPECT_NEAR(early, 0.2 * ui::commands::time_span(driver.state())[1], 0.02);
    const Eigen::Matrix3Xd body = driver.window->scene().positions;
    EXPECT_EQ(seen_markers(driver, true), 4);
    // The simulated tip hangs where the simulated body's tip is.
    const ui::commands::TimePlace place = ui::commands::place_in_time(driver.state().scene_trial()->time_s, early);
    const Eigen::Vector3d tip = ui::commands::at_time(driver.state().simulated_trial()->markers[0], place);
    double nearest = 1.0;
    for (Eigen::Index i = 0; i < body.cols(); ++i) nearest = std::min(nearest, (body.col(i) - tip).norm());
    EXPECT_LT(nearest, 0.01);
    EXPECT_LT(tip.z(), 0.0);  // it started at 14 mm and has fallen

    scrub_to(driver, 0.9f);
    EXPECT_GT(driver.state().time_s, early);
    EXPECT_GT((driver.window->scene().positions - body).colwise().norm().maxCoeff(), 1e-3);
}

/// Its data come from another mesh of other cells, and from no other physics.
TEST(BundledExample, LacksNothing) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.click("task/diagnose");
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(driver.wait_for_job(300));
    ASSERT_TRUE(driver.state().diagnosis && driver.state().diagnosis->complete) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().diagnosis->verdict, ui::commands::DiagnosisVerdict::none)
        << driver.state().diagnosis->headline;
    for (const ui::commands::DiagnosisTrial& trial : driver.state().diagnosis->trials)
        EXPECT_LT(trial.before_m, 1.3 * driver.state().diagnosis->noise_m) << trial.name;
    EXPECT_EQ(ui::commands::task_status(driver.state(), ui::commands::Task::diagnose).state,
              ui::commands::TaskState::done);
}

/// Cancels a calibration of the bundled example on a coarse mesh once it has done this many evaluations.
void cancel_calibration_at(Driver& driver, double evaluations) {
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.01;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.click("run/calibrate");
    ASSERT_TRUE(driver.state().busy());
    driver.frame();
    // The choice of the time step, before it, counts trials.
    const auto reached = [&](const ProgressEvent& at) {
        return evaluations == 0.0 || (at.task == "fit" && at.done >= evaluations);
    };
    while (driver.state().busy() && !reached(driver.state().job->progress)) driver.frame_beside_job();
    ASSERT_TRUE(driver.state().busy());
    driver.click("run/cancel");
    ASSERT_TRUE(driver.wait_for_job(20));
}

TEST(BundledExample, CancelsACalibrationThatHasNoValuesYet) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    ASSERT_NO_FATAL_FAILURE(cancel_calibration_at(driver, 0.0));
    EXPECT_FALSE(driver.state().run);
    EXPECT_FALSE(driver.state().found);
    EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::information);
}

TEST(BundledExample, KeepsTheBestValuesOfACancelledCalibration) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    ASSERT_NO_FATAL_FAILURE(cancel_calibration_at(driver, 2.5));
    ASSERT_TRUE(driver.state().found) << driver.state().log.back().text;
    const ui::commands::SearchResult& kept = *driver.state().found;
    EXPECT_TRUE(kept.stopped);
    EXPECT_GE(kept.evaluations, 2);
    EXPECT_LE(kept.rms_after_m, kept.rms_before_m);
    EXPECT_EQ(driver.state().settings, kept.settings);
    EXPECT_TRUE(driver.state().can_undo);
    // The validation trial was not run: it shows the body at rest and its measured markers only.
    ASSERT_TRUE(driver.state().run_is_current());
    for (int trial = 0; trial < 3; ++trial) {
        driver.workbench->execute(ui::commands::ChooseTrial{trial});
        driver.settle();
        const bool fitted = driver.state().scene_trial()->role == "fit";
        EXPECT_EQ(driver.state().simulated_trial()->frames.empty(), !fitted);
        EXPECT_EQ(driver.window->scene().positions.cols(), driver.state().body->mesh.nodes.cols());
    }
}

}  // namespace
}  // namespace myo
