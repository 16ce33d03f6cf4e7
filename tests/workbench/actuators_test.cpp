#include <gtest/gtest.h>

#include <cmath>

#include "backend/workbench_backend.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

void open_example(Driver& driver, const std::string& name) {
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/" + name);
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().body) << driver.state().log.back().text;
}

TEST(ShownActuators, TintTheWallsOfAChamberAndListItsPressure) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    open_example(driver, "pneumatic_finger");
    const ui::commands::MeshedBody& body = *driver.state().body;
    ASSERT_EQ(body.actuators.chambers.size(), 1u);
    const ui::commands::ShownChamber& chamber = body.actuators.chambers[0];
    EXPECT_NEAR(chamber.volume_m3, 0.06 * 0.01 * 0.005, 1e-15);
    EXPECT_NEAR(chamber.wall_area_m2, 2.0 * (0.06 * 0.01 + 0.06 * 0.005 + 0.01 * 0.005), 1e-12);
    // Each wall has its nodes on the declared box.
    const Eigen::Vector3d lowest(0.0075, 0.005, 0.010), highest(0.0675, 0.015, 0.015);
    ASSERT_FALSE(chamber.walls.empty());
    for (const int wall : chamber.walls)
        for (const int node : body.boundary.nodes.col(wall)) {
            const Eigen::Vector3d x = body.mesh.nodes.col(node);
            EXPECT_TRUE(((x - lowest).array() > -0.003).all() && ((highest - x).array() > -0.003).all());
        }
    const ui::viewport::DrawnScene drawn = driver.window->scene();
    ASSERT_EQ(drawn.tints.cols(), body.boundary.count());
    EXPECT_EQ((drawn.tints.row(3).array() > 0.0f).count(), static_cast<Eigen::Index>(chamber.walls.size()));

    const ui::commands::ShownCommand& pressure = driver.state().scene->trials[0].commands.at("chamber");
    EXPECT_EQ(pressure.unit, "kPa");
    EXPECT_EQ(pressure.signal.value(0.1), 25000.0);
    EXPECT_EQ(pressure.signal.value(-0.1), 0.0);
    driver.click("task/fibres");
    driver.frame();
    EXPECT_GT(driver.item("fibres/actuator/chamber").width(), 0.0f);
}

TEST(ShownActuators, DrawTendonsThroughTheirGuides) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    open_example(driver, "tendon_tentacle");
    const ui::commands::BodyActuators& actuators = driver.state().body->actuators;
    ASSERT_EQ(actuators.tendons.size(), 2u);
    int threads = 0;
    for (const ui::viewport::DrawnLine& line : driver.window->scene().lines) {
        if (line.points.cols() != 9 || line.width < 2.0) continue;
        ++threads;
        // Before any run the thread passes the declared guides: from the clamp to 155 mm below it.
        EXPECT_NEAR(line.points(2, 0), 0.0, 1e-9);
        EXPECT_NEAR(line.points(2, 8), -0.155, 1e-9);
        EXPECT_NEAR(std::abs(line.points(0, 0)), 0.0077, 1e-5);
    }
    EXPECT_EQ(threads, 2);
    EXPECT_EQ(driver.state().scene->trials[2].commands.at("left").signal.value(0.0), 4.0);
    EXPECT_EQ(driver.state().scene->trials[2].commands.at("left").unit, "N");
}

TEST(ShownActuators, HaveKnotsThatEditTheTrial) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    open_example(driver, "pneumatic_finger");
    driver.window->show_panel("signals");
    driver.settle();
    const auto pressure = [&] { return driver.state().scene_trial()->commands.at("chamber").signal; };
    const fibre::Signal before = pressure();
    ASSERT_EQ(before, fibre::Signal::step(0.0, 0.0, 25000.0));
    // Up goes the level of the step; a knot more makes a curve of it.
    driver.click("signals/snap");
    const float high = driver.item("signals/knot/chamber/1").center().y,
                low = driver.item("signals/knot/chamber/0").center().y;
    const ImVec2 level = driver.item("signals/knot/chamber/1").center();
    driver.drag(level, {level.x, high + 0.4f * (low - high)});
    EXPECT_EQ(pressure(), fibre::Signal::step(0.0, 0.0, 15000.0)) << driver.state().refused;
    EXPECT_EQ(driver.state().scene->declared.commands[0].at("chamber").kind, ui::commands::DeclaredCommand::Kind::step);
    const ImVec2 place{driver.item("signals/knot/chamber/1").center().x + 200.0f, low - 5.0f};
    driver.window->input().push(ui::platform::MouseMoved{place.x, place.y});
    for (const bool down : {true, false, true, false})
        driver.window->input().push(ui::platform::MouseButton{0, down, {}});
    driver.settle();
    ASSERT_EQ(pressure().times_s.size(), 3u) << driver.state().refused;
    EXPECT_EQ(driver.state().scene->declared.commands[0].at("chamber").curve, pressure());
    EXPECT_EQ(driver.state().scene->declared.commands[0].size(), 1u);
    for (int step = 0; step < 2; ++step) driver.click("bar/undo");
    EXPECT_EQ(pressure(), before);
    EXPECT_FALSE(driver.state().can_undo);
    // A trial whose pressure is recorded keeps it.
    driver.workbench->execute(ui::commands::ChooseTrial{1});
    driver.settle();
    EXPECT_TRUE(driver.has("plot/command/kPa"));
    EXPECT_FALSE(driver.has("signals/knot/chamber/0"));
}

}  // namespace
}  // namespace myo
