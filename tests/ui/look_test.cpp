#include <gtest/gtest.h>

#include <algorithm>

#include "commands/body_cut.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/face_table.hpp"
#include "ui/driver.hpp"
#include "viewport/scene_renderer.hpp"

// Looking into the body: the plane that cuts it, what a click tells, and distances.

namespace myo::ui {
namespace {

using Eigen::Vector3d;
using test::Driver;

/// Its middle is at x = 50 mm: the beam is 100 x 30 x 30 mm.
void cut_beam(Driver& driver) {
    driver.click("view/options");
    driver.click("view/clip");
    ASSERT_TRUE(driver.state().view.clip.on);
}

commands::ReportLine line(const Driver& driver, const std::string& label) {
    const auto lines = commands::lines_about(*driver.window->inspect_tool().picked(), driver.state(),
                                             driver.window->scene(), nullptr);
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const commands::ReportLine& each) { return each.label == label; });
    EXPECT_NE(found, lines.end()) << label;
    return found != lines.end() ? *found : commands::ReportLine{};
}

TEST(FaceTable, BoundaryOfAPartIsThatOfAMeshOfItsCells) {
    for (const mesh::CellType type : {mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = mesh::tet_box_mesh({Vector3d::Zero(), Vector3d(3.0, 2.0, 2.0)}, {3, 2, 2}, type);
        std::vector<char> kept(static_cast<std::size_t>(mesh.cell_count()));
        std::vector<Eigen::Index> cells;
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
            if ((kept[static_cast<std::size_t>(c)] = c % 3 != 1)) cells.push_back(c);
        const mesh::BoundaryFaces part = mesh::boundary_of_part(mesh::face_table(mesh), kept);
        const mesh::BoundaryFaces alone = mesh::boundary_faces({type, mesh.nodes, mesh.cells(Eigen::all, cells)});
        ASSERT_EQ(part.count(), alone.count());
        EXPECT_EQ(part.nodes, alone.nodes);
        for (Eigen::Index f = 0; f < part.count(); ++f)
            EXPECT_EQ(part.cell(f), cells[static_cast<std::size_t>(alone.cell(f))]);
    }
}

TEST(Cut, HidesElementsAndShowsTheFacesThatComeFree) {
    Driver driver;
    driver.open_beam();
    const mesh::BoundaryFaces whole = driver.window->scene().body->faces;
    cut_beam(driver);
    const viewport::DrawnScene& scene = driver.window->scene();
    ASSERT_TRUE(scene.body);
    EXPECT_LT(scene.body->faces.count(), whole.count());
    EXPECT_EQ(scene.surface->triangle_count(),
              static_cast<std::size_t>(scene.body->faces.count() * scene.surface->triangles_per_face()));
    const Eigen::Matrix3Xd& X = driver.state().body->mesh.nodes;
    const Eigen::Matrix3Xd& centres = driver.state().ground->places.centre_m;
    int inner = 0;
    for (Eigen::Index f = 0; f < scene.body->faces.count(); ++f) {
        EXPECT_LE(centres(0, scene.body->faces.cell(f)), 0.05 + 1e-12);
        const Vector3d middle = X(Eigen::all, scene.body->faces.nodes.col(f)).rowwise().mean();
        const bool outside = middle.x() < 1e-9 || middle.y() < 1e-9 || middle.z() < 1e-9 || middle.y() > 0.03 - 1e-9 ||
                             middle.z() > 0.03 - 1e-9;
        inner += outside ? 0 : 1;
    }
    EXPECT_GT(inner, 0) << "the cut itself is closed by faces";
    // Both parts together have the body's faces and the cut's, twice.
    const Eigen::Index first = scene.body->faces.count();
    driver.click("view/clip_flip");
    EXPECT_EQ(first + driver.window->scene().body->faces.count(), whole.count() + 2 * inner);
    driver.click("view/clip");
    EXPECT_EQ(driver.window->scene().body->faces.nodes, whole.nodes);
}

TEST(Cut, ThePlaneIsMovedAndTurned) {
    Driver driver;
    driver.open_beam();
    cut_beam(driver);
    driver.click("view/clip_z");
    EXPECT_EQ(driver.state().view.clip.normal, Vector3d::UnitZ().eval());
    EXPECT_NEAR(driver.state().view.clip.position_m, 0.015, 1e-12);
    const platform::Rectangle slider = driver.item("view/clip_position");
    driver.click_at({slider.lowest.x + 0.02f * slider.width(), slider.center().y});
    EXPECT_LT(driver.state().view.clip.position_m, 0.003);
    EXPECT_EQ(driver.window->scene().surface->triangle_count(), 0u)
        << "nothing lies below: an empty picture is drawn, too";
    driver.click("view/clip_view");
    EXPECT_NEAR((driver.state().view.clip.normal - viewport::camera_axes(driver.window->viewport().camera).back).norm(),
                0.0, 1e-12);
    // Another body is shown whole.
    driver.open_beam();
    EXPECT_FALSE(driver.state().view.clip.on);
}

TEST(Cut, TheOutlineIsWhereThePlaneMeetsTheBox) {
    const Box box{Vector3d::Zero(), Vector3d(2.0, 1.0, 1.0)};
    const Eigen::Matrix3Xd square = commands::outline_of({true, Vector3d::UnitX(), 0.5, false}, box);
    ASSERT_EQ(square.cols(), 5);
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR((square.col(i + 1) - square.col(i)).norm(), 1.0, 1e-12);
    EXPECT_EQ(commands::outline_of({true, Vector3d::UnitX(), 3.0, false}, box).cols(), 0);
}

TEST(Inspect, AClickNamesTheNodeAndTheElement) {
    Driver driver;
    driver.open_beam();
    const mesh::VolumeMesh& mesh = driver.state().body->mesh;
    // A node of the side y = 0 that is seen, away from the markers.
    int node = -1;
    for (int n = 0; n < mesh.node_count(); ++n)
        if (mesh.nodes(1, n) < 1e-9 && (node < 0 || (mesh.nodes.col(n) - Vector3d(0.03, 0.0, 0.015)).norm() <
                                                        (mesh.nodes.col(node) - Vector3d(0.03, 0.0, 0.015)).norm()))
            node = n;
    const Vector3d aim = mesh.nodes.col(node) + Vector3d(5e-4, 0.0, 5e-4);
    driver.click_at(test::pixel_of(driver, aim));
    const auto& picked = driver.window->inspect_tool().picked();
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->node, node);
    const Eigen::Matrix3Xd corners = mesh.nodes(Eigen::all, mesh.cells.col(picked->cell));
    EXPECT_TRUE((corners.rowwise().minCoeff().array() <= aim.array() + 1e-4).all() &&
                (corners.rowwise().maxCoeff().array() >= aim.array() - 1e-4).all());
    EXPECT_TRUE(driver.has("view/inspector"));
    EXPECT_EQ(line(driver, "Node").value, std::to_string(node));
    EXPECT_EQ(line(driver, "Displacement").value, "0.000 mm");
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.window->inspect_tool().picked());
    driver.settle();
    EXPECT_FALSE(driver.has("view/inspector"));
}

TEST(Inspect, ThroughTheCutInnerElementsAreFound) {
    Driver driver;
    driver.open_beam();
    const ImVec2 place = test::pixel_of(driver, {0.03, 0.0, 0.018});
    driver.click_at(place);
    ASSERT_TRUE(driver.window->inspect_tool().picked());
    const int outer = driver.window->inspect_tool().picked()->cell;
    // Not by the list, which would lie over the place.
    commands::ViewOptions view = driver.state().view;
    view.clip = {true, Vector3d::UnitY(), 0.015, true};
    driver.workbench->execute(commands::ChangeView{view});
    driver.settle();
    driver.click_at(place);
    ASSERT_TRUE(driver.window->inspect_tool().picked());
    const int inner = driver.window->inspect_tool().picked()->cell;
    EXPECT_NE(inner, outer);
    EXPECT_GT(driver.state().ground->places.centre_m(1, inner), 0.015);
}

TEST(Inspect, AMarkerIsNamedAndChosenAndADragIsNoClick) {
    Driver driver;
    driver.open_beam();
    const auto& markers = driver.state().scene->markers;
    ASSERT_GE(markers.size(), 2u);
    const int last = static_cast<int>(markers.size()) - 1;
    ASSERT_NE(driver.state().marker, last);
    const viewport::DrawnScene& scene = driver.window->scene();
    const auto drawn = std::find_if(scene.markers.begin(), scene.markers.end(),
                                    [&](const viewport::DrawnMarker& m) { return m.number == last; });
    ASSERT_NE(drawn, scene.markers.end());
    const ImVec2 place = test::pixel_of(driver, drawn->position);
    driver.click_at(place);
    ASSERT_TRUE(driver.window->inspect_tool().picked());
    EXPECT_EQ(driver.window->inspect_tool().picked()->marker, last);
    EXPECT_EQ(driver.state().marker, last);
    EXPECT_EQ(line(driver, "Marker").value, markers.back().name);
    const platform::Rectangle view = driver.item("view");
    driver.drag({view.lowest.x + 40.0f, view.highest.y - 150.0f}, {view.lowest.x + 90.0f, view.highest.y - 150.0f});
    EXPECT_TRUE(driver.window->inspect_tool().picked()) << "turning the view keeps it";
    driver.click_at({view.lowest.x + 40.0f, view.highest.y - 150.0f});
    EXPECT_FALSE(driver.window->inspect_tool().picked()) << "a click beside all ends it";
}

TEST(Distance, TwoClicksMeasureAndFollowTheMotion) {
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_d);
    EXPECT_TRUE(driver.window->viewport().measuring);
    driver.click_at(test::pixel_of(driver, {0.031, 0.0, 0.012}));
    driver.click_at(test::pixel_of(driver, {0.071, 0.0, 0.012}));
    ASSERT_EQ(driver.window->distance_tool().distances().size(), 1u);
    EXPECT_FALSE(driver.window->inspect_tool().picked()) << "the clicks were for the distance";
    const double pixel = viewport::metres_per_pixel(driver.window->viewport().camera, driver.window->viewport().size());
    EXPECT_NEAR(driver.window->distance_tool().distances()[0].at_rest_m, 0.040, 3.0 * pixel);
    EXPECT_NEAR(driver.window->distance_tool().distances()[0].now_m,
                driver.window->distance_tool().distances()[0].at_rest_m, 1e-9);
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{0.1});
    driver.settle();
    const panels::MeasuredDistance& moved = driver.window->distance_tool().distances().at(0);
    EXPECT_GT(std::abs(moved.now_m - moved.at_rest_m), 1e-6);
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.window->viewport().measuring);
    EXPECT_EQ(driver.window->distance_tool().distances().size(), 1u) << "it stays until it is cleared";
}

TEST(Translucent, WhatIsInsideTheBodyIsSeenAsFarAsTheBodyLetsThrough) {
    Driver driver;
    driver.draw_pixels();
    driver.open_beam();
    auto renderer = viewport::SceneRenderer::make();
    ASSERT_TRUE(renderer);
    viewport::DrawnScene scene = driver.window->scene();
    scene.grid = scene.edges = false;
    scene.markers.clear();
    viewport::DrawnLine arrow;
    arrow.points.resize(3, 2);
    arrow.points << 0.02, 0.08, 0.015, 0.015, 0.015, 0.015;  // along the beam's axis
    arrow.color = viewport::Color(1.0f, 0.0f, 0.0f, 1.0f);
    arrow.width = 6.0;
    const viewport::ViewSize size{400, 300};
    const viewport::Camera camera = viewport::fit(viewport::Camera{}, size, scene.extent);
    const auto place = viewport::project(camera, size, {0.05, 0.015, 0.015});
    ASSERT_TRUE(place);
    std::uint64_t revision = 0;
    const auto color = [&](double opacity, bool with) {
        scene.body_opacity = opacity;
        scene.lines.clear();
        if (with) scene.lines.push_back(arrow);
        EXPECT_TRUE(renderer->update(scene, ++revision,
                                     viewport::view_colors(platform::make_theme(platform::ThemeName::dark, 1.0f)),
                                     camera, size, 4, 1.0));
        const auto c = renderer->read().color(static_cast<int>(place->x()), static_cast<int>(place->y()));
        return c[0] - c[1];
    };
    const int through_opaque = color(1.0, true) - color(1.0, false),
              through_glass = color(0.4, true) - color(0.4, false);
    EXPECT_GT(through_opaque, 20) << "faintly";
    EXPECT_GT(through_glass, 2 * through_opaque);
    EXPECT_GT(through_glass, 110) << "of 255: the arrows of forces stand out";
}

TEST(MenuBar, NothingLiesUnderAnotherInASmallWindowWithLargeLetters) {
    Driver driver(900, 600);
    driver.open_beam();
    for (const float scale : {1.0f, 1.5f, 2.0f}) {
        driver.workbench->execute(commands::SetTheme{platform::ThemeName::dark, scale});
        driver.settle();
        std::vector<platform::Rectangle> shown;
        for (const auto& [item, place] : driver.window->items().all())
            if (item.rfind("bar/", 0) == 0 || item == "menu/file" || item == "menu/edit" || item == "menu/view" ||
                item == "menu/run" || item == "menu/help")
                shown.push_back(place);
        ASSERT_GE(shown.size(), 5u);
        for (std::size_t a = 0; a < shown.size(); ++a) {
            EXPECT_LE(shown[a].highest.x, 900.0f) << scale;
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_TRUE(shown[a].highest.x <= shown[b].lowest.x + 1.0f ||
                            shown[b].highest.x <= shown[a].lowest.x + 1.0f)
                    << "at scale " << scale;
        }
    }
}

}  // namespace
}  // namespace myo::ui
