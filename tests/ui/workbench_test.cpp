#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/files.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/file_browser.hpp"
#include "panels/screenshot.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(Workbench, OpensByTypingAPath) {
    Driver driver;
    EXPECT_FALSE(driver.state().scene);
    driver.click("body/path");
    driver.type("/beam");
    driver.key(ImGuiKey_Enter);
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_EQ(driver.state().scene->path, "/beam");
    ASSERT_TRUE(driver.state().body);
    EXPECT_EQ(driver.state().body->mesh.cell_count(), 20 * 6 * 6);
    EXPECT_EQ(driver.state().prediction.elements, 720.0);
}

TEST(Workbench, SaysWhyAFileCannotBeOpened) {
    Driver driver;
    driver.window->open("/missing");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().scene);
    ASSERT_FALSE(driver.state().log.empty());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
    EXPECT_NE(driver.state().log.back().text.find("/missing"), std::string::npos);
}

TEST(Workbench, AsksForTheUnitOfAMesh) {
    Driver driver;
    driver.window->open("/body.stl");
    driver.settle();
    EXPECT_FALSE(driver.state().busy());
    driver.click("unit/mm");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_NEAR(mesh::bounding_box(driver.state().scene->surface.vertices).size().x(), 0.1, 1e-12);
}

TEST(Workbench, RunsScrubsAndDrawsMarkersWhereTheyProject) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().run);
    EXPECT_EQ(driver.state().run->trials.size(), 2u);
    EXPECT_TRUE(driver.state().run_is_current());

    const platform::Rectangle track = driver.item("timeline/track");
    driver.click_at({track.lowest.x + 0.4f * track.width(), track.center().y});
    EXPECT_NEAR(driver.state().time_s, -0.2 + 0.4 * 2.2, 0.05);

    const platform::Theme theme = platform::make_theme(platform::ThemeName::dark, 1.0f);
    const platform::Image image = driver.picture();
    const auto& scene = driver.window->scene();
    int spheres = 0;
    int rings = 0;
    for (const viewport::DrawnMarker& marker : scene.markers) {
        const bool hidden = marker.position.y() > 0.029;  // on the far side
        if (hidden || !marker.position.allFinite()) continue;
        (marker.ring ? rings : spheres) += 1;
        EXPECT_TRUE(test::color_near(image, test::pixel_of(driver, marker.position),
                                     marker.ring ? theme.simulated : theme.measured, 12))
            << marker.label << (marker.ring ? " simulated" : " measured");
    }
    EXPECT_EQ(spheres, 3);
    EXPECT_EQ(rings, 3);
    // The simulated tip is where the closed form says.
    const commands::TimePlace place = commands::place_in_time(driver.state().scene_trial()->time_s,
                                                              driver.state().time_s);
    const Eigen::Vector3d tip = commands::at_time(driver.state().simulated_trial()->markers[0], place);
    EXPECT_LT((tip - test::beam_point({0.1, 0.0, 0.024}, 2.6e5, driver.state().time_s)).norm(), 2e-4);
}

TEST(Workbench, BodyFollowsTheTime) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{-0.1});
    driver.settle();
    const Eigen::Matrix3Xd at_rest = driver.window->scene().positions;
    EXPECT_LT((at_rest - driver.state().body->mesh.nodes).norm(), 1e-12);
    driver.workbench->execute(commands::SetTime{0.17});
    driver.settle();
    EXPECT_GT((driver.window->scene().positions - at_rest).colwise().norm().maxCoeff(), 0.01);
}

TEST(Workbench, CalibratesAndUndoes) {
    Driver driver;
    driver.open_beam();
    driver.click("run/calibrate");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().found);
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, test::SwingingBeam::measured_modulus);
    EXPECT_LT(driver.state().found->rms_after_m, driver.state().found->rms_before_m);
    EXPECT_TRUE(driver.state().run_is_current());
    driver.click("bar/undo");
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 2.6e5);
    EXPECT_FALSE(driver.state().run_is_current());
    driver.key(ImGuiKey_Y, {.ctrl = true});
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, test::SwingingBeam::measured_modulus);
}

TEST(Workbench, StaysLiveWhileAJobRunsAndCancelsIt) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.02;
    driver.click("run/run");
    ASSERT_TRUE(driver.state().busy());
    for (int i = 0; i < 10; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        driver.frame();
    }
    EXPECT_GT(driver.state().job->fraction(), 0.0);
    driver.workbench->execute(commands::SetTime{1.0});
    EXPECT_EQ(driver.state().time_s, 1.0);
    driver.workbench->execute(commands::Run{});
    ASSERT_EQ(driver.state().queue.size(), 1u) << "a second job waits";
    driver.workbench->execute(commands::Unqueue{driver.state().queue.front().id});
    driver.click("run/cancel");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().run);
    EXPECT_EQ(driver.state().log.back().text, "Simulation cancelled.");
}

TEST(Workbench, TypesANumberIntoAField) {
    Driver driver;
    driver.open_beam();
    driver.double_click("model/youngs_modulus");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("310");
    driver.key(ImGuiKey_Enter);
    EXPECT_NEAR(driver.state().settings.youngs_modulus_Pa, 3.1e5, 1e-6);
    // Values outside are refused; see number_field_test.cpp.
    const double before = driver.state().settings.poissons_ratio;
    driver.double_click("model/poissons_ratio");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("7");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().settings.poissons_ratio, before);
}

TEST(Workbench, OneDragOfAFieldIsOneUndo) {
    Driver driver;
    driver.open_beam();
    const double before = driver.state().settings.density_kg_m3;
    const ImVec2 from = driver.item("model/density").center();
    driver.drag(from, {from.x + 60.0f, from.y});
    EXPECT_GT(driver.state().settings.density_kg_m3, before + 20.0);
    driver.click("bar/undo");
    EXPECT_EQ(driver.state().settings.density_kg_m3, before);
    EXPECT_FALSE(driver.state().can_undo);
}

TEST(Workbench, ElementAndResolutionChangeThePredictionAndTheMesh) {
    Driver driver;
    driver.open_beam();
    driver.click("body/element");
    driver.click("body/element/tet10");
    EXPECT_EQ(driver.state().settings.element, mesh::CellType::tet10);
    EXPECT_FALSE(driver.state().mesh_is_current());
    const double before = driver.state().prediction.elements;
    const platform::Rectangle slider = driver.item("body/resolution");
    driver.click_at({slider.lowest.x + 0.9f * slider.width(), slider.center().y});
    EXPECT_LT(driver.state().prediction.elements, before);
    driver.click("body/build");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().body->mesh.type, mesh::CellType::tet10);
    EXPECT_EQ(static_cast<double>(driver.state().body->mesh.cell_count()), driver.state().prediction.elements);
}

TEST(Workbench, AFinerMeshIsNotForetoldFewerElementsThanThereAre) {
    Driver driver;
    driver.open_beam();
    driver.click("body/element");
    driver.click("body/element/tet10");
    driver.click("body/build");
    ASSERT_TRUE(driver.wait_for_job());
    driver.backend->fewer_foretold = true;
    commands::Settings finer = driver.state().settings;
    finer.resolution_m *= 0.9;
    driver.workbench->execute(commands::ChangeSettings{finer, "resolution"});
    EXPECT_GE(driver.state().prediction.elements, static_cast<double>(driver.state().body->mesh.cell_count()));
    EXPECT_GE(driver.state().prediction.dofs, driver.state().body->dofs);
    const commands::MeshPrediction own = driver.backend->predict(*driver.state().scene, finer);
    EXPECT_NEAR(driver.state().prediction.dofs / driver.state().prediction.elements, own.dofs / own.elements, 1e-9)
        << "elements and unknowns belong together";
}

/// As of every other number.
TEST(Workbench, TheEdgeLengthCanBeTyped) {
    Driver driver;
    driver.open_beam();
    driver.double_click("body/edge_length");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("12");
    driver.key(ImGuiKey_Enter);
    EXPECT_NEAR(driver.state().settings.resolution_m, 0.012, 1e-12);
}

TEST(Workbench, ShowsTheNumericalDampingOfImplicitEuler) {
    Driver driver;
    driver.open_beam();
    driver.click("task/run");
    EXPECT_FALSE(driver.has("model/numerical_damping"));
    driver.click("model/integrator");
    driver.click("model/integrator/implicit_euler");
    EXPECT_TRUE(driver.has("model/numerical_damping"));
    EXPECT_EQ(driver.state().damping_frequency_Hz, 7.75);
}

TEST(Workbench, SetsTheStepByItsSliderAndShowsTheMeasuredDampingOverIt) {
    Driver driver;
    driver.open_beam();
    driver.click("task/run");
    EXPECT_FALSE(driver.has("model/damping_curve"));
    driver.click("model/integrator");
    driver.click("model/integrator/implicit_euler");
    EXPECT_TRUE(driver.has("model/measured_damping"));
    const platform::Rectangle slider = driver.item("model/time_step/slider");
    driver.click_at({slider.lowest.x + 0.75f * slider.width(), slider.center().y});
    // Logarithmic from 0.01 to 100 ms.
    EXPECT_NEAR(std::log10(driver.state().settings.time_step_s), -2.0, 0.15);
}

TEST(Workbench, ShowsHowMuchVelocityForceTheStepBears) {
    Driver driver;
    driver.open_beam();
    driver.click("task/run");
    EXPECT_FALSE(driver.has("model/velocity_force/stable"));
    driver.click("model/integrator");
    driver.click("model/integrator/implicit_euler");
    ASSERT_TRUE(driver.has("model/velocity_force/unstable"));
    const auto critical = [&] { return driver.state().critical_velocity_force_1_s.value_or(0.0); };
    const double before = critical(), h = driver.state().settings.time_step_s;
    EXPECT_GT(before, 0.0);
    commands::Settings settings = driver.state().settings;
    settings.time_step_s = 0.5 * h;
    driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
    driver.settle();
    EXPECT_NEAR(critical(), 0.5 * before, 1e-9);
    EXPECT_FALSE(driver.state().is_unstable());
    driver.click_at(driver.item("model/velocity_force/unstable").center());
    EXPECT_NEAR(driver.state().settings.velocity_force_1_s, 1.5 * critical(), 0.1 * critical());
    EXPECT_TRUE(driver.state().is_unstable());
    driver.click_at(driver.item("model/velocity_force/stable").center());
    EXPECT_LT(driver.state().settings.velocity_force_1_s, critical());
    EXPECT_FALSE(driver.state().is_unstable());
}

TEST(Workbench, WarnsOfAVelocityForceThatMakesTheMotionGrow) {
    Driver driver;
    driver.open_beam();
    driver.click("model/integrator");
    driver.click("model/integrator/implicit_euler");
    const auto push = [&](double velocity_force_1_s) {
        commands::Settings settings = driver.state().settings;
        settings.velocity_force_1_s = velocity_force_1_s;
        driver.workbench->execute(commands::ChangeSettings{settings, "test", false});
        driver.frame();
        driver.frame();
    };
    push(10.0);
    ASSERT_TRUE(driver.state().critical_velocity_force_1_s.has_value());
    const double critical = *driver.state().critical_velocity_force_1_s;
    push(0.9 * critical);
    EXPECT_FALSE(driver.has("run/unstable"));
    push(1.1 * critical);
    EXPECT_TRUE(driver.has("run/unstable"));
    push(0.0);
    EXPECT_FALSE(driver.has("run/unstable"));
}

TEST(Workbench, OffersTheSpectralRadiusOfGeneralisedAlphaOnly) {
    Driver driver;
    driver.open_beam();
    driver.click("task/run");
    EXPECT_FALSE(driver.has("model/spectral_radius"));
    driver.click("model/integrator");
    driver.click("model/integrator/generalized_alpha");
    driver.frame();
    EXPECT_TRUE(driver.has("model/spectral_radius"));
}

TEST(Workbench, PlaysToTheEndAndStops) {
    Driver driver;
    driver.open_beam();
    driver.key(ImGuiKey_Space);
    EXPECT_TRUE(driver.state().playing);
    EXPECT_TRUE(driver.window->must_draw());
    for (int i = 0; i < 100 && driver.state().playing; ++i) driver.frame(0.05);
    EXPECT_FALSE(driver.state().playing);
    EXPECT_EQ(driver.state().time_s, 2.0);
}

TEST(Workbench, IdleFramesDrawNothingAnew) {
    Driver driver;
    driver.open_beam();
    for (int i = 0; i < 4; ++i) driver.frame();
    EXPECT_FALSE(driver.window->must_draw());
    const int before = driver.window->scene_draw_count();
    for (int i = 0; i < 3; ++i) driver.frame();
    EXPECT_EQ(driver.window->scene_draw_count(), before);
    driver.window->wake();
    EXPECT_TRUE(driver.window->must_draw());
}

TEST(Viewport, DragTurnsWheelZoomsButtonsLookAlongAxes) {
    Driver driver;
    driver.open_beam();
    const viewport::Camera start = driver.window->viewport().camera;
    const ImVec2 middle = driver.item("view").center();
    driver.drag(middle, {middle.x + 80.0f, middle.y});
    const viewport::Camera turned = driver.window->viewport().camera;
    EXPECT_NEAR(turned.yaw, start.yaw - 0.64, 1e-6);
    EXPECT_EQ(turned.distance, start.distance);
    driver.wheel(middle, 2.0f);
    EXPECT_LT(driver.window->viewport().camera.distance, 0.8 * start.distance);
    driver.drag(middle, {middle.x, middle.y + 50.0f}, 1);
    EXPECT_GT((driver.window->viewport().camera.target - turned.target).norm(), 1e-3);
    driver.click("view/y");
    EXPECT_NEAR(driver.window->viewport().camera.pitch, 0.0, 1e-12);
    // All of the body is in sight again.
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, 0.03, 0.03)}) {
        EXPECT_TRUE(driver.item("view").contains(test::pixel_of(driver, corner)));
    }
}

TEST(MarkerPlot, CursorFollowsAClickAndTheTimeFollowsTheCursor) {
    Driver driver;
    driver.open_beam();
    const platform::Rectangle plot = driver.item("plot/x");
    driver.click_at({plot.lowest.x + 0.75f * plot.width(), plot.center().y});
    EXPECT_NEAR(driver.state().time_s, -0.2 + 0.75 * 2.2, 0.02);
    const ImVec2 cursor = driver.item("plot/z/cursor").center();
    const platform::Rectangle z = driver.item("plot/z");
    driver.drag(cursor, {z.lowest.x + 0.25f * z.width(), cursor.y});
    EXPECT_NEAR(driver.state().time_s, -0.2 + 0.25 * 2.2, 0.02);
}

TEST(MarkerPlot, ZoomIsSharedAndEndsByDoubleClick) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    const float before = driver.item("plot/z/cursor").center().x;
    const platform::Rectangle plot = driver.item("plot/x");
    driver.wheel({plot.highest.x - 2.0f, plot.center().y}, 3.0f);
    // The cursor at t = 0 leaves to the left in the other plots as well.
    EXPECT_LT(driver.item("plot/z/cursor").center().x, before - 20.0f);
    EXPECT_LT(driver.item("residual/y/cursor").center().x, driver.item("residual/y").lowest.x);
    driver.double_click("plot/x");
    EXPECT_NEAR(driver.item("residual/y/cursor").center().y, driver.item("residual/y").center().y, 2.0f);
    EXPECT_GT(driver.item("residual/y/cursor").center().x, driver.item("residual/y").lowest.x);
}

TEST(MarkerPlot, MarkerIsChosenFromTheList) {
    Driver driver;
    driver.open_beam();
    driver.click("markers/marker");
    driver.click("markers/marker/middle");
    EXPECT_EQ(driver.state().marker, 3);
    driver.click("markers/show/y");
    EXPECT_FALSE(driver.has("plot/y"));
    EXPECT_TRUE(driver.has("plot/x"));
}

TEST(Layout, NothingIsCutOffAtUsualSizes) {
    for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1600, 900}}) {
        Driver driver(width, height);
        driver.open_beam();
        driver.click("run/run");
        ASSERT_TRUE(driver.wait_for_job());
        for (const float scale : {1.0f, 1.25f, 1.5f}) {
            driver.workbench->execute(commands::SetTheme{platform::ThemeName::light, scale});
            driver.settle();
            for (const char* name : {"run/run", "run/calibrate", "bar/theme", "bar/scale", "timeline/speed",
                                     "timeline/trial", "timeline/track", "plot/x", "plot/z", "residual/z",
                                     "markers/fit", "view/options", "panel/messages"}) {
                const platform::Rectangle r = driver.item(name);
                EXPECT_GE(r.lowest.x, 0.0f) << name;
                EXPECT_LE(r.highest.x, static_cast<float>(width)) << name << " at " << scale;
                EXPECT_LE(r.highest.y, static_cast<float>(height)) << name << " at " << scale;
                EXPECT_GT(r.width(), 20.0f) << name << " at " << scale;
                EXPECT_GT(r.height(), 14.0f) << name << " at " << scale;
            }
            EXPECT_GT(driver.item("timeline/track").width(), 100.0f) << scale;
            EXPECT_GT(driver.item("view").height(), 200.0f) << scale;
        }
    }
}

TEST(Layout, EdgesCanBeDragged) {
    Driver driver;
    driver.open_beam();
    const float before = driver.item("view").width();
    const ImVec2 edge = driver.item("edge/rail_edge").center();
    driver.drag(edge, {edge.x + 80.0f, edge.y});
    EXPECT_NEAR(driver.item("view").width(), before - 80.0f, 3.0f);
}

TEST(FileBrowser, ListsWhatCanBeOpenedAndOpensIt) {
    const auto folder = std::filesystem::temp_directory_path() / "myoloop_file_browser_test";
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(write_file(folder / "beam" / "experiment.toml", "schema = \"experiment/1\"\n"));
    ASSERT_TRUE(write_file(folder / "body.STL", "solid"));
    ASSERT_TRUE(write_file(folder / "notes.txt", ""));
    const auto entries = panels::list_folder(folder, {".stl", ".toml"});
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_TRUE(entries[0].experiment);
    EXPECT_EQ(entries[1].name, "body.STL");
    EXPECT_TRUE(panels::list_folder(folder / "nowhere", {}).empty());

    Driver driver;
    driver.click("body/path");
    driver.type(folder.string());
    driver.click("body/browse");
    driver.click("browser/entry/beam");
    driver.click("browser/open");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_EQ(driver.state().scene->path, folder / "beam");
    std::filesystem::remove_all(folder);
}

TEST(Screenshot, IsDrawnWithoutADisplay) {
    panels::ScreenshotOptions options;
    options.open = "/beam";
    options.width = 900;
    options.height = 600;
    options.time_s = 0.2;
    const auto image = panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options);
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->width, 900);
    const auto file = std::filesystem::temp_directory_path() / "myoloop_screenshot_test.png";
    ASSERT_TRUE(platform::write_png(*image, file));
    EXPECT_EQ(read_file(file)->substr(1, 3), "PNG");
    std::filesystem::remove(file);
    // The same picture again, bit for bit.
    const auto again = panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options);
    EXPECT_EQ(image->rgba, again->rgba);
}

TEST(Screenshot, SaysWhatIsWrong) {
    panels::ScreenshotOptions options;
    options.open = "/missing";
    const auto missing = panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options);
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("/missing"), std::string::npos);
    options.open = "/body.stl";
    EXPECT_FALSE(panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options));
    options.open = "/beam";
    options.panels = {"nonsense"};
    EXPECT_NE(panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options).error().text().find("markers"),
              std::string::npos);
    options.panels.clear();
    options.trial = "nonsense";
    EXPECT_NE(
        panels::draw_screenshot(std::make_shared<test::SwingingBeam>(), options).error().text().find("gravity_release"),
        std::string::npos);
}

TEST(TimePlace, HoldsTheEndsAndLeavesGapsOpen) {
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(5, 0.0, 4.0);
    Eigen::Matrix3Xd track = Eigen::Matrix3Xd::Zero(3, 5);
    track.row(0) << 0, 1, NAN, 3, 4;
    EXPECT_EQ(commands::at_time(track, commands::place_in_time(time, -7.0)).x(), 0.0);
    EXPECT_EQ(commands::at_time(track, commands::place_in_time(time, 9.0)).x(), 4.0);
    EXPECT_EQ(commands::at_time(track, commands::place_in_time(time, 1.0)).x(), 1.0);
    EXPECT_EQ(commands::at_time(track, commands::place_in_time(time, 3.5)).x(), 3.5);
    EXPECT_TRUE(std::isnan(commands::at_time(track, commands::place_in_time(time, 1.5)).x()));
    EXPECT_EQ(commands::place_in_time(Eigen::VectorXd(), 0.0).index, -1);
}

}  // namespace
}  // namespace myo::ui
