#include <gtest/gtest.h>

#include <algorithm>

#include "backend/project_file.hpp"
#include "backend/workbench_backend.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

double last_height_m(const Driver& driver) {
    const Eigen::Matrix3Xd& tip = driver.state().run->trials.front().markers.front();
    return tip(2, tip.cols() - 1);
}

void run(Driver& driver) {
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    EXPECT_TRUE(driver.state().run->problem.empty()) << driver.state().run->problem;
}

/// The whole path by hand: a muscle painted along the top of the beam lifts its tip, and one that extends there lowers
/// it.
TEST(PaintedMuscle, BendsTheBeamToItsSide) {
    Driver driver(backend::make_core_backend(), 1280, 900);
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.01;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_NO_FATAL_FAILURE(run(driver));
    const double passive = last_height_m(driver);

    driver.workbench->execute(ui::commands::SetTime{0.0});
    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/add");
    driver.key(ui::platform::key_b);
    for (const double y : {0.005, 0.015, 0.025})
        driver.drag(test::pixel_of(driver, {0.02, y, 0.02}), test::pixel_of(driver, {0.1, y, 0.02}));
    const fibre::PaintedAmount amount = fibre::amount_of(*driver.state().chosen_paint(),
                                                         driver.state().ground->volumes_m3);
    EXPECT_NEAR(amount.volume_m3, 0.09 * 0.03 * 0.01, 0.25 * 0.09 * 0.03 * 0.01) << "the upper layer below the strokes";
    ASSERT_NO_FATAL_FAILURE(run(driver));
    EXPECT_GT(last_height_m(driver), passive + 0.005);

    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/action");
    driver.click("fibres/action/extends");
    EXPECT_DOUBLE_EQ(driver.state().chosen_muscle()->signal->values.back(), 1.2);
    ASSERT_NO_FATAL_FAILURE(run(driver));
    EXPECT_LT(last_height_m(driver), passive - 0.002);
}

/// A project whose mask is gone opens with everything else, and the log names what is missing.
TEST(PaintedMuscle, WhoseMaskIsMissingIsOpenedWithoutPaintAndToldInTheLog) {
    const test::Folder folder("project_without_mask");
    Driver driver(backend::make_core_backend(), 1280, 900);
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    fibre::PaintedMask mask;
    mask.cell_size_m = 0.004;
    mask.centroids_m = Eigen::Vector3d(0.06, 0.015, 0.018);
    mask.weights = Eigen::VectorXd::Ones(1);
    mask.directions = Eigen::Vector3d::UnitX();
    ui::commands::Project project;
    project.source = driver.state().scene->path;
    project.settings = driver.state().settings;
    ui::commands::Muscle painted;
    painted.name = "painted";
    painted.stiffness_Pa = 1e5;
    painted.paint = std::make_shared<const fibre::PaintedMask>(mask);
    project.settings.muscles.push_back(painted);
    const std::filesystem::path file = folder.path() / "beam.myoloop";
    ASSERT_TRUE(backend::write_project_file(file, project));
    std::filesystem::remove_all(folder.path() / "beam.files");
    driver.window->open(file);
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_EQ(driver.state().project, file) << driver.state().log.back().text;
    ASSERT_EQ(driver.state().settings.muscles.size(), 1u);
    EXPECT_FALSE(driver.state().settings.muscles[0].paint);
    const auto told = [](const auto& entry) {
        return entry.level == ui::commands::LogLevel::warning &&
               entry.text.find("paint of muscle \"painted\" is lost") != std::string::npos;
    };
    EXPECT_TRUE(std::any_of(driver.state().log.begin(), driver.state().log.end(), told));
}

}  // namespace
}  // namespace myo
