#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "backend/workbench_backend.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

/// A preview moves as the whole run begins, effects and late starts included, and is compared alike as far as it goes.
void expect_beginning(const std::string& example, std::size_t trial, double end_s) {
    SCOPED_TRACE(example);
    const std::shared_ptr<ui::commands::Backend> backend = backend::make_core_backend();
    const Result<ui::commands::Scene> scene = backend->open(
        std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/" + example, std::nullopt, {});
    ASSERT_TRUE(scene) << scene.error().text();
    const Result<ui::commands::MeshedBody> body = backend->mesh(*scene, scene->settings, {});
    ASSERT_TRUE(body) << body.error().text();
    ui::commands::Settings settings = scene->settings;
    settings.own_step = true;  // else the whole run may choose a shorter one
    const Result<ui::commands::RunResult> whole = backend->simulate(*scene, *body, settings, std::nullopt, {});
    const Result<ui::commands::RunResult> part = backend->simulate(*scene, *body, settings,
                                                                   ui::commands::RunExtent{trial, end_s}, {});
    ASSERT_TRUE(whole && part);
    ASSERT_EQ(part->trials.size(), whole->trials.size());
    const ui::commands::SimulatedTrial& full = whole->trials[trial];
    const ui::commands::SimulatedTrial& first = part->trials[trial];
    const std::size_t frames = first.frames.size();
    ASSERT_GT(frames, 3u);
    ASSERT_LT(frames, full.frames.size());
    EXPECT_LE(first.frame_time_s(first.frame_time_s.size() - 1), end_s * (1.0 + 1e-9));
    EXPECT_GT(full.frame_time_s(static_cast<Eigen::Index>(frames)), end_s * (1.0 + 1e-9));
    for (std::size_t f = 0; f < frames; ++f) {
        EXPECT_EQ(first.frame_time_s(static_cast<Eigen::Index>(f)), full.frame_time_s(static_cast<Eigen::Index>(f)));
        EXPECT_LT((first.frames[f] - full.frames[f]).cwiseAbs().maxCoeff(), 1e-12);
    }
    const Eigen::VectorXd& time_s = scene->trials[trial].time_s;
    int compared = 0;
    for (std::size_t m = 0; m < first.markers.size(); ++m)
        for (Eigen::Index t = 0; t < time_s.size(); ++t) {
            const bool inside = time_s(t) <= end_s * (1.0 + 1e-9);
            ASSERT_EQ(first.markers[m].col(t).allFinite(), inside);
            if (!inside) continue;
            EXPECT_LT((first.markers[m].col(t) - full.markers[m].col(t)).norm(), 1e-12);
            ++compared;
        }
    EXPECT_GT(compared, 10);
    EXPECT_TRUE(std::isfinite(first.rms_m));
    for (std::size_t t = 0; t < part->trials.size(); ++t) EXPECT_EQ(part->trials[t].frames.empty(), t != trial);
}

TEST(CorePreview, IsTheBeginningOfTheWholeRun) {
    expect_beginning("silicone_beam", 1, 0.2);
    expect_beginning("soft_arm", 0, 0.1);
}

TEST(CorePreview, AStifferBeamIsSeenToHangLess) {
    Driver driver(backend::make_core_backend(), 1200, 800);
    driver.workbench->execute(
        ui::commands::Open{std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam", std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::SetTime{0.05});
    const auto lowest_at = [&](double E) {
        ui::commands::Settings settings = driver.state().settings;
        settings.youngs_modulus_Pa = E;
        driver.workbench->execute(ui::commands::ChangeSettings{settings, "test", false});
        for (int i = 0; i < 20000 && driver.state().preview.working; ++i) {
            driver.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        driver.settle();
        EXPECT_TRUE(driver.state().previewing());
        return driver.window->scene().positions.row(2).minCoeff();
    };
    driver.workbench->execute(ui::commands::ChangePreview{true, 0.1});
    const double soft = lowest_at(1.5e5), stiff = lowest_at(4e5);
    EXPECT_LT(soft, stiff - 1e-4);
    EXPECT_TRUE(driver.state().history.empty());
    EXPECT_FALSE(driver.state().run);
}

}  // namespace
}  // namespace myo
