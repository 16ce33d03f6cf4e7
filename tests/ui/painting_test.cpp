#include <gtest/gtest.h>

#include <cmath>

#include "ui/driver.hpp"
#include "viewport/picking.hpp"

namespace myo::ui {
namespace {

using Eigen::Vector3d;
using test::Driver;

/// The beam (100 x 30 x 30 mm) with one muscle that is not painted yet, and the brush in hand.
void take_brush(Driver& driver) {
    driver.open_beam();
    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/add");
    ASSERT_EQ(driver.state().settings.muscles.size(), 1u);
    driver.key(ui::platform::key_b);
    ASSERT_EQ(driver.state().brush.tool, commands::BrushTool::add);
}

/// Along the middle of the side y = 0.
void stroke(Driver& driver, double from_x, double to_x) {
    driver.drag(test::pixel_of(driver, {from_x, 0.0, 0.015}), test::pixel_of(driver, {to_x, 0.0, 0.015}));
}

const fibre::CellPaint& paint_of(const Driver& driver) { return *driver.state().chosen_paint(); }

double painted_volume(const Driver& driver) {
    return fibre::amount_of(paint_of(driver), driver.state().ground->volumes_m3).volume_m3;
}

TEST(Painting, AStrokePaintsWhatItPassesAndFibresFollowIt) {
    Driver driver;
    take_brush(driver);
    const commands::BrushSettings brush = driver.state().brush;
    stroke(driver, 0.03, 0.07);
    const fibre::CellPaint& paint = paint_of(driver);
    const fibre::CellPlaces& places = driver.state().ground->places;
    int painted = 0;
    for (Eigen::Index c = 0; c < paint.count(); ++c) {
        const Vector3d x = places.centre_m.col(c);
        // Distance from the stroke's line in the plane of the side, and depth below it.
        const double beside = std::hypot(std::max({0.03 - x.x(), x.x() - 0.07, 0.0}), x.z() - 0.015);
        const bool inside = beside < brush.radius_m - 1e-3 &&
                                x.y()<brush.depth_m - 1e-3, outside = beside> brush.radius_m + 1e-3 ||
                            x.y() > brush.depth_m + 1e-3;
        EXPECT_FALSE(inside && paint.weights(c) == 0.0) << x.transpose();
        EXPECT_FALSE(outside && paint.weights(c) > 0.0) << x.transpose();
        if (!(paint.weights(c) > 0.0)) continue;
        ++painted;
        EXPECT_GT(std::abs(paint.directions.col(c).x()), 0.99) << "the stroke ran along x";
    }
    EXPECT_GT(painted, 20);
    EXPECT_TRUE(driver.state().settings.muscles[0].paint);
}

TEST(Painting, TheFaceUnderTheStrokeTakesTheMusclesColour) {
    Driver driver;
    take_brush(driver);
    const ImVec2 place = test::pixel_of(driver, {0.052, 0.0, 0.012});
    const std::array<int, 3> before = driver.picture().color(static_cast<int>(place.x), static_cast<int>(place.y));
    stroke(driver, 0.03, 0.07);
    driver.window->input().push(platform::MouseMoved{5.0f, 5.0f});  // the ring out of the way
    driver.settle();
    const std::array<int, 3> after = driver.picture().color(static_cast<int>(place.x), static_cast<int>(place.y));
    // The first colour is a vermilion, the body a grey.
    EXPECT_GT(after[0] - after[2], before[0] - before[2] + 40);
}

TEST(Painting, EachStrokeIsOneStepOfUndo) {
    Driver driver;
    take_brush(driver);
    std::vector<double> volumes{painted_volume(driver)};
    for (const double x : {0.02, 0.05, 0.08}) {
        stroke(driver, x - 0.004, x + 0.004);
        volumes.push_back(painted_volume(driver));
        EXPECT_GT(volumes.back(), volumes[volumes.size() - 2]);
    }
    for (int step = 2; step >= 0; --step) {
        driver.key(ImGuiKey_Z, {.ctrl = true});
        EXPECT_EQ(painted_volume(driver), volumes[static_cast<std::size_t>(step)]) << step;
    }
    for (int step = 1; step <= 3; ++step) {
        driver.key(ImGuiKey_Y, {.ctrl = true});
        EXPECT_EQ(painted_volume(driver), volumes[static_cast<std::size_t>(step)]) << step;
    }
}

TEST(Painting, ErasesGrowsShrinksAndClears) {
    Driver driver(1280, 1200);
    take_brush(driver);
    stroke(driver, 0.03, 0.07);
    const double first = painted_volume(driver);
    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/grow");
    const double grown = painted_volume(driver);
    EXPECT_GT(grown, first);
    driver.click("fibres/shrink");
    EXPECT_LT(painted_volume(driver), grown);
    driver.key(ui::platform::key_e);
    const double before = painted_volume(driver);
    stroke(driver, 0.045, 0.055);
    EXPECT_LT(painted_volume(driver), before);
    driver.click("fibres/clear");
    EXPECT_EQ(painted_volume(driver), 0.0);
}

TEST(Painting, ADragBesideTheBodyTurnsTheView) {
    Driver driver;
    take_brush(driver);
    const viewport::Camera before = driver.window->viewport().camera;
    const platform::Rectangle view = driver.item("view");
    driver.drag({view.highest.x - 60.0f, view.highest.y - 60.0f}, {view.highest.x - 120.0f, view.highest.y - 90.0f});
    EXPECT_NE(driver.window->viewport().camera.yaw, before.yaw);
    EXPECT_EQ(painted_volume(driver), 0.0);
    const viewport::Camera turned = driver.window->viewport().camera;
    stroke(driver, 0.04, 0.06);
    EXPECT_EQ(driver.window->viewport().camera, turned) << "a stroke does not";
    EXPECT_GT(painted_volume(driver), 0.0);
}

TEST(Painting, SurvivesAnotherMesh) {
    Driver driver;
    take_brush(driver);
    stroke(driver, 0.03, 0.07);
    const double before = painted_volume(driver);
    for (const mesh::CellType element : {mesh::CellType::tet4, mesh::CellType::hex8}) {
        commands::Settings settings = driver.state().settings;
        settings.element = element;
        settings.resolution_m = 0.004;
        driver.workbench->execute(commands::ChangeSettings{settings, "mesh", false});
        driver.workbench->execute(commands::BuildMesh{});
        ASSERT_TRUE(driver.wait_for_job());
        EXPECT_NEAR(painted_volume(driver), before, 0.12 * before) << to_string(element);
    }
}

TEST(Painting, TheLastOfTwoAntagonistsKeepsItsOwnSignalWhenTheOtherGoes) {
    Driver driver;
    take_brush(driver);
    driver.click("fibres/add");
    ASSERT_EQ(driver.state().muscle, 1);
    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/follows");
    driver.click("fibres/follows/muscle 1");
    EXPECT_EQ(driver.state().settings.muscles[1].follows, "muscle 1");
    driver.workbench->execute(commands::ChooseMuscle{0});
    driver.settle();
    driver.click("fibres/remove");
    ASSERT_EQ(driver.state().settings.muscles.size(), 1u);
    EXPECT_TRUE(driver.state().settings.muscles[0].follows.empty());
    EXPECT_TRUE(driver.state().settings.muscles[0].signal);
}

TEST(Picking, ARayMeetsThePlaceThatFallsOnItsPixel) {
    const Box box{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};
    const mesh::SurfaceMesh surface = mesh::box_surface(box);
    viewport::DrawnSurface drawn = viewport::drawn_surface(surface);
    drawn.closed = true;
    const viewport::ViewSize size{800, 600};
    const viewport::Camera camera = viewport::fit(viewport::Camera{}, size, box);
    for (const Vector3d& place : {Vector3d(0.03, 0.0, 0.02), Vector3d(0.06, 0.013, 0.03), Vector3d(0.1, 0.02, 0.011)}) {
        const auto pixel = viewport::project(camera, size, place);
        ASSERT_TRUE(pixel);
        const auto hit = viewport::pick_surface(drawn, surface.vertices,
                                                viewport::ray_through(camera, size, pixel->head<2>()));
        ASSERT_TRUE(hit);
        EXPECT_LT((hit->place(drawn, surface.vertices) - place).norm(), 1e-9);
    }
    EXPECT_FALSE(viewport::pick_surface(drawn, surface.vertices, viewport::ray_through(camera, size, {1.0, 1.0})));
}

}  // namespace
}  // namespace myo::ui
