#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "workbench/by_hand.hpp"
#include "workbench/opened_beam.hpp"

// Obstacles and parts of an experiment, from their panels to the run.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;
using testing::HasSubstr;

double lowest_height_m(const Driver& driver) {
    double lowest = 0.0;
    for (const Eigen::Matrix3Xd& frame : driver.state().simulated_trial()->frames)
        lowest = std::min(lowest, frame.row(2).minCoeff());
    return lowest;
}

TEST(ObstaclesInWindow, AFloorUnderTheBeamStopsIt) {
    OpenedBeam beam("obstacle_floor");
    beam.keep_step();
    Driver& driver = beam.driver;
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const double falls_to = lowest_height_m(driver);
    driver.window->show_panel("obstacle");
    driver.settle();
    driver.click("obstacle/add_plane");
    driver.settle();
    ASSERT_EQ(driver.state().scene->obstacles.size(), 1u) << driver.state().refused;
    const auto plane = std::get<ui::commands::ScenePlane>(driver.state().scene->obstacles[0].shape);
    EXPECT_EQ(plane.normal, Eigen::Vector3d::UnitZ()) << "against gravity";
    EXPECT_LT(plane.point_m.z(), 0.0);
    ASSERT_LT(falls_to, plane.point_m.z() - 0.003);
    EXPECT_EQ(driver.state().view.edited, "obstacle/0") << "what was added is open";
    EXPECT_TRUE(driver.state().mesh_is_current());
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_GT(lowest_height_m(driver), plane.point_m.z() - 0.0005);
    driver.window->show_panel("obstacle");
    driver.settle();
    test::type_into(driver, "obstacle/0/point/z", "-500 mm");
    EXPECT_EQ(std::get<ui::commands::ScenePlane>(driver.state().scene->obstacles[0].shape).point_m.z(), -0.5);
    test::type_into(driver, "obstacle/0/friction", "0,4");
    EXPECT_EQ(driver.state().scene->obstacles[0].friction, 0.4);
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_NEAR(lowest_height_m(driver), falls_to, 1e-9) << "too far below to be reached";
    for (int step = 0; step < 3; ++step) driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->obstacles.empty()) << "three edits, three steps";
}

TEST(ObstaclesInWindow, SpheresAndBoxesBeginBesideTheBodyAndCannotMoveIntoIt) {
    OpenedBeam beam("obstacle_shapes");
    Driver& driver = beam.driver;
    driver.window->show_panel("obstacle");
    driver.settle();
    driver.click("obstacle/add_sphere");
    driver.settle();
    driver.click("obstacle/add_box");
    driver.settle();
    ASSERT_EQ(driver.state().scene->obstacles.size(), 2u) << driver.state().refused;
    EXPECT_TRUE(std::holds_alternative<ui::commands::SceneSphere>(driver.state().scene->obstacles[0].shape));
    EXPECT_TRUE(std::holds_alternative<Box>(driver.state().scene->obstacles[1].shape));
    driver.click("obstacle/0");
    driver.settle();
    test::type_into(driver, "obstacle/0/centre/z", "0");
    EXPECT_THAT(driver.state().refused, HasSubstr("the body lies in it at rest"));
    driver.click("obstacle/0/remove");
    ASSERT_EQ(driver.state().scene->obstacles.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<Box>(driver.state().scene->obstacles[0].shape));
}

TEST(PartsInWindow, AStiffPartBendsLessAndOnlyItsBoxAsksForAMesh) {
    OpenedBeam beam("part_stiff");
    Driver& driver = beam.driver;
    driver.window->show_panel("part");
    driver.settle();
    driver.click("part/add");
    driver.settle();
    ASSERT_EQ(driver.state().scene->parts.size(), 1u) << driver.state().refused;
    const ui::commands::ScenePart part = driver.state().scene->parts[0];
    EXPECT_EQ(part.youngs_modulus_Pa, driver.state().settings.youngs_modulus_Pa) << "nothing changes at first";
    ASSERT_TRUE(part.box_m);
    EXPECT_GT(part.box_m->lowest.x(), 0.03) << "the half away from the support";
    EXPECT_FALSE(driver.state().mesh_is_current()) << "the mesh meets the faces of the box";
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_TRUE(driver.state().mesh_is_current());
    const double soft = beam.last_height_m();
    driver.window->show_panel("part");
    driver.settle();
    test::type_into(driver, "part/0/youngs_modulus", "5 MPa");
    EXPECT_EQ(driver.state().scene->parts[0].youngs_modulus_Pa, 5e6);
    EXPECT_TRUE(driver.state().mesh_is_current()) << "a modulus leaves the mesh as it is";
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_GT(std::abs(beam.last_height_m() - soft), 2e-4);
    driver.window->show_panel("part");
    driver.settle();
    driver.click("part/0/fit_youngs_modulus");
    EXPECT_THAT(driver.state().scene->calibrated, testing::Contains(HasSubstr("modulus of part")));
    driver.click("part/0/own_damping");
    EXPECT_EQ(driver.state().scene->parts[0].damping_s, driver.state().settings.damping_s);
    test::type_into(driver, "part/0/box/x_from", "70 mm");
    EXPECT_FALSE(driver.state().mesh_is_current());
    driver.click("part/0/remove");
    EXPECT_TRUE(driver.state().scene->parts.empty());
}

}  // namespace
}  // namespace myo
