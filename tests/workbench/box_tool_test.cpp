#include <gtest/gtest.h>

#include "workbench/opened_beam.hpp"

// Boxes of the declaration are dragged by their sides in the view.

namespace myo {
namespace {

using test::OpenedBeam;
using test::pixel_of;

Eigen::Vector3d side_of(const Box& box, int axis, bool upper) {
    Eigen::Vector3d place = 0.5 * (box.lowest + box.highest);
    place(axis) = (upper ? box.highest : box.lowest)(axis);
    return place;
}

TEST(BoxTool, MovesOneSideOfTheSupportAsOneStep) {
    OpenedBeam beam("box_tool");
    test::Driver& driver = beam.driver;
    driver.window->show_panel("fit");
    driver.settle();
    EXPECT_FALSE(driver.has("view/support/box/x_to")) << "its numbers are not shown";
    driver.window->show_panel("support");
    driver.settle();
    ASSERT_TRUE(driver.has("view/support/box/x_to"));
    const Box before = *driver.state().scene->clamp_m;
    // Where the side is, and 20 mm further along x.
    const Eigen::Vector3d side = side_of(before, 0, true);
    const ImVec2 from = pixel_of(driver, side), to = pixel_of(driver, side + Eigen::Vector3d(0.02, 0.0, 0.0));
    driver.drag(from, to);
    const Box after = *driver.state().scene->clamp_m;
    EXPECT_NEAR(after.highest.x() - before.highest.x(), 0.02, 1e-3) << driver.state().refused;
    EXPECT_EQ(after.lowest, before.lowest);
    EXPECT_EQ(after.highest.y(), before.highest.y());
    EXPECT_EQ(after.highest.z(), before.highest.z());
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().scene->clamp_m->highest, before.highest) << "one step";
}

/// A side does not pass the opposite one, and Escape leaves the box as it was.
TEST(BoxTool, KeepsTheBoxABox) {
    OpenedBeam beam("box_tool_thin");
    test::Driver& driver = beam.driver;
    driver.window->show_panel("support");
    driver.settle();
    const Box before = *driver.state().scene->clamp_m;
    const Eigen::Vector3d side = side_of(before, 2, true);
    const double height = before.highest.z() - before.lowest.z();
    driver.drag(pixel_of(driver, side), pixel_of(driver, side - Eigen::Vector3d(0.0, 0.0, 2.0 * height)));
    const Box thin = *driver.state().scene->clamp_m;
    EXPECT_GE(thin.highest.z(), thin.lowest.z()) << driver.state().refused;
    EXPECT_EQ(thin.lowest, before.lowest);
}

}  // namespace
}  // namespace myo
