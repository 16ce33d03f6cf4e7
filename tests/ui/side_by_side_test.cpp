#include <gtest/gtest.h>

#include "ui/driver.hpp"

// Two runs side by side, and the undeformed outline.

namespace myo::ui {
namespace {

using test::Driver;

void run(Driver& driver, double youngs_modulus_Pa) {
    commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa = youngs_modulus_Pa;
    driver.workbench->execute(commands::ChangeSettings{settings, "modulus"});
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
}

/// A stiff run, compared with the shown one of a soft beam.
void compare(Driver& driver) {
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(run(driver, 5e5));
    const int stiff = driver.state().history.back().id;
    ASSERT_NO_FATAL_FAILURE(run(driver, 1.5e5));
    driver.workbench->execute(commands::CompareRecord{stiff});
    commands::ViewOptions view = driver.state().view;
    view.side_by_side = true;
    view.field = "height";
    driver.workbench->execute(commands::ChangeView{view});
    driver.workbench->execute(commands::SetTime{0.3});
    driver.settle();
    for (int i = 0; i < 200 && driver.window->must_draw(); ++i) driver.frame_beside_job();
}

TEST(SideBySide, DrawsEachRunInItsHalfAtTheSameTime) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(compare(driver));
    ASSERT_TRUE(driver.has("view/compared"));
    const platform::Rectangle left = driver.item("view"), right = driver.item("view/compared");
    EXPECT_NEAR(left.highest.x, right.lowest.x, 1.5f);
    EXPECT_NEAR(left.width(), right.width(), 2.0f);
    const viewport::DrawnScene &shown = driver.window->scene(), &other = driver.window->compared_scene();
    ASSERT_EQ(shown.positions.cols(), other.positions.cols());
    EXPECT_GT((shown.positions - other.positions).cwiseAbs().maxCoeff(), 1e-3) << "the soft beam sinks further";
    const commands::SimulatedTrial& stiff = driver.state().history[0].run->trials[0];
    double nearest = 1.0;
    for (const Eigen::Matrix3Xd& frame : stiff.frames)
        nearest = std::min(nearest, (frame - other.positions).cwiseAbs().maxCoeff());
    EXPECT_LT(nearest, 5e-4) << "a frame of the compared run, or between two";
    ASSERT_TRUE(shown.field && other.field);
    EXPECT_EQ(shown.field->lowest, other.field->lowest);
    EXPECT_EQ(shown.field->highest, other.field->highest);
}

TEST(SideBySide, ADragInEitherHalfTurnsBoth) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(compare(driver));
    const viewport::Camera before = driver.window->viewport().camera;
    const ImVec2 at = driver.item("view/compared").center();
    driver.drag(at, {at.x + 60.0f, at.y + 20.0f});
    EXPECT_FALSE(driver.window->viewport().camera == before);
}

TEST(SideBySide, AModelThatPlaysLiveMovesInItsHalfOnly) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(compare(driver));
    const Eigen::Matrix3Xd recorded = driver.window->compared_scene().positions;
    driver.workbench->execute(commands::PlayLive{true});
    const auto& live = driver.state().live;
    for (int i = 0; i < 200 && !(live && live->ready); ++i) driver.frame_beside_job();
    ASSERT_TRUE(live && live->ready);
    driver.frame();
    EXPECT_NE(driver.window->scene().positions, recorded);
    EXPECT_EQ(driver.window->compared_scene().positions, recorded);
}

TEST(SideBySide, TintsTheChambersOfTheComparedMesh) {
    Driver driver;
    driver.backend->has_chamber = true;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(run(driver, 5e5));
    const commands::JobRecord fine = driver.state().history.back();
    commands::Settings settings = driver.state().settings;
    settings.resolution_m *= 2.0;
    driver.workbench->execute(commands::ChangeSettings{settings, "resolution"});
    ASSERT_NO_FATAL_FAILURE(run(driver, 5e5));
    ASSERT_NE(driver.state().body, fine.on.body);
    driver.workbench->execute(commands::CompareRecord{fine.id});
    commands::ViewOptions view = driver.state().view;
    view.side_by_side = true;
    driver.workbench->execute(commands::ChangeView{view});
    driver.settle();
    const viewport::DrawnScene& other = driver.window->compared_scene();
    ASSERT_TRUE(other.body);
    ASSERT_EQ(other.tints.cols(), fine.on.body->boundary.count());
    for (Eigen::Index f = 0; f < other.tints.cols(); ++f) {
        const double x = fine.on.body->mesh.nodes(0, other.body->faces.nodes.col(f)).mean();
        EXPECT_EQ(other.tints(3, f) > 0.0f, x > 0.1 - 1e-9) << f;
    }
}

TEST(SideBySide, WithoutAComparedRunIsOneView) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(run(driver, 2e5));
    commands::ViewOptions view = driver.state().view;
    view.side_by_side = true;
    driver.workbench->execute(commands::ChangeView{view});
    driver.settle();
    EXPECT_FALSE(driver.has("view/compared"));
}

TEST(View, ShowsTheUndeformedOutline) {
    Driver driver;
    driver.open_beam();
    ASSERT_NO_FATAL_FAILURE(run(driver, 1.5e5));
    const std::size_t without = driver.window->scene().lines.size();
    driver.click("view/options");
    driver.click("view/undeformed");
    EXPECT_TRUE(driver.state().view.undeformed);
    ASSERT_EQ(driver.window->scene().lines.size(), without + 1);
    const Eigen::Matrix3Xd& nodes = driver.state().body->mesh.nodes;
    for (const viewport::DrawnLine& line : driver.window->scene().lines) {
        // Every edge is there once: 3 columns each, the third dividing them.
        if (line.points.cols() < 3 || line.points.col(2).allFinite() || line.points.cols() % 3 != 0) continue;
        for (Eigen::Index i = 0; i < line.points.cols(); i += 3)
            EXPECT_LT((nodes.colwise() - line.points.col(i)).colwise().norm().minCoeff(), 1e-15);
        return;
    }
    FAIL() << "no outline";
}

}  // namespace
}  // namespace myo::ui
