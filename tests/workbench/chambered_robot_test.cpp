#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/surface_mesh.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/figures.hpp"
#include "workbench/own_robot.hpp"

// A person with a body that is blown up: from its surface to a pressure that brings a marker to its goal, by widgets.

namespace myo {
namespace {

using Eigen::Vector3d;

class ChamberedRobot : public test::OwnRobot {
protected:
    static constexpr const char* pressure_item = "chamber/chamber1/pressure";

    /// An arm of 80 x 30 x 20 mm with a flat cavity above its middle, as a drawing program writes it.
    static void write_arm(const std::filesystem::path& stl) {
        mesh::SurfaceMesh cavity = mesh::box_surface({{0.01, 0.01, 0.01}, {0.07, 0.02, 0.015}});
        cavity.triangles.row(1).swap(cavity.triangles.row(2));  // towards the inside of the cavity
        ASSERT_TRUE(mesh::write_stl(
            stl, test::together(mesh::box_surface({{0.0, 0.0, 0.0}, {0.08, 0.03, 0.02}}), cavity), 1e-3));
    }
    /// Clicks on the cut body until the wall of its cavity is hit.
    void choose_chamber() {
        panel("chamber");
        ASSERT_EQ(state().scene->declared.cavities.size(), 1u) << "the cavity is found";
        EXPECT_NEAR(state().scene->declared.cavities[0].volume_m3, 3e-6, 1e-11);
        driver.click("chamber/pick");
        ASSERT_TRUE(state().view.clip.on);
        edit([&] {
            for (double x = 0.012; x < 0.07 && state().scene->declared.chambers.empty(); x += 0.004)
                for (double z = 0.0105; z < 0.015 && state().scene->declared.chambers.empty(); z += 0.001)
                    driver.click_at(test::pixel_of(driver, {x, 0.015, z}));
        });
        ASSERT_THAT(state().scene->declared.chambers, testing::ElementsAre("chamber1")) << state().refused;
        driver.settle();
        EXPECT_FALSE(state().view.clip.on) << "the body is whole again";
    }
    /// A curve of pressure over the shown trial.
    void draw_pressure(const std::string& last) {
        panel("chamber");
        edit([&] { pick(std::string(pressure_item) + "/kind", "curve"); });
        edit_number(std::string(pressure_item) + "/curve/1/time", "0.2 s");
        edit_number(std::string(pressure_item) + "/curve/1/value", last);
        EXPECT_NEAR(state().scene_trial()->commands.at("chamber1").signal.value(0.1), 20e3, 1e-6) << state().refused;
    }
};

TEST_F(ChamberedRobot, GoesFromItsSurfaceToAPressureThatReachesAGoal) {
    const test::Folder folder("chambered_robot");
    ASSERT_NO_FATAL_FAILURE(write_arm(folder.path() / "arm.stl"));
    ASSERT_NO_FATAL_FAILURE(open_body(folder.path() / "arm.stl", folder));
    const std::string first = declaration(folder);
    begin_edits();
    // As they are offered: the lower end of the longest axis is held, and z is up. The arm lies on a table, though.
    panel("support");
    EXPECT_LT(state().scene->clamp_m->highest.x(), 0.01);
    EXPECT_LT(state().scene->gravity_m_s2.z(), -9.0);
    edit([&] { pick("support/end", "x_low"); });
    edit([&] { pick("support/gravity", "none"); });
    ASSERT_NO_FATAL_FAILURE(mesh("5"));
    ASSERT_NO_FATAL_FAILURE(choose_chamber());
    panel("probe");
    edit([&] {
        driver.click("probe/place");
        type_into("probe/next", "tip", false);
        driver.click_at(test::pixel_of(driver, {0.075, 0.015, 0.02}));
        driver.click("probe/place");
    });
    ASSERT_EQ(state().scene->markers.size(), 1u) << state().refused;
    ASSERT_EQ(state().scene->markers[0].name, "tip");
    panel("trial");
    edit([&] { driver.click("trial/add"); });
    edit_number("trial/duration", "0.3 s");
    ASSERT_NO_FATAL_FAILURE(draw_pressure("40 kPa"));
    ASSERT_NO_FATAL_FAILURE(run());

    // Half as far as that pressure bends it.
    show_time(0.3);
    const Vector3d rest = state().scene->markers[0].rest_m, bent = simulated_place("tip");
    EXPECT_GT((bent - rest).norm(), 1e-3);
    panel("goal");
    edit([&] { driver.click("goal/add"); });
    edit_place("goal/0/place", bent, 0.5 * (rest + bent));
    driver.click("task/fit");
    driver.settle();
    EXPECT_FALSE(driver.has("fit/lowest")) << "there is no muscle to bound";
    edit([&] { driver.click("fit/limit/pressure_Pa/set"); });
    edit_number("fit/limit/pressure_Pa", "60 kPa");
    EXPECT_EQ(state().scene->declared.limits.at("pressure_Pa"), 60e3) << state().refused;
    edit([&] {
        driver.click("fit/optimize");
        ASSERT_NO_FATAL_FAILURE(wait(300));
    });
    ASSERT_TRUE(state().found) << state().log.back().text;
    const ui::commands::SearchResult& found = *state().found;
    test::record("goal_rms_m", std::vector<double>{found.rms_before_m, found.rms_after_m});
    EXPECT_LT(found.rms_after_m, 0.2 * found.rms_before_m) << found.problem;
    show_time(0.3);
    EXPECT_LT((simulated_place("tip") - 0.5 * (rest + bent)).norm(), 5e-4);
    EXPECT_LT(state().scene_trial()->commands.at("chamber1").signal.value(0.3), 35e3)
        << "the found pressure is declared";
    undo_edits();
    EXPECT_EQ(declaration(folder), first);
}

}  // namespace
}  // namespace myo
