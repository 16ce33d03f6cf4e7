#include "mesh/surface_check.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "mesh/surface_reader.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "support/shared_data.hpp"

namespace myo::mesh {
namespace {

const Box unit_box{{0, 0, 0}, {0.01, 0.01, 0.01}};

TEST(CheckSurface, GoodBodies) {
    for (const SurfaceMesh& s :
         {box_surface(unit_box), test::cylinder(32, 0.01, 0.05), test::l_shape(), weld(test::sphere(3, 0.02))}) {
        const SurfaceReport report = check_surface(s);
        EXPECT_TRUE(report.closed && report.manifold && report.oriented && report.outward && report.plausible);
        EXPECT_EQ(report.self_intersections, 0);
        EXPECT_EQ(report.components, 1);
        EXPECT_TRUE(report.messages.empty()) << report.messages.front();
    }
    EXPECT_NEAR(check_surface(test::l_shape()).volume, 3e-6, 1e-18);
    EXPECT_NEAR(check_surface(test::l_shape()).area, 2 * 3e-4 + 0.08 * 0.01, 1e-15);
}

TEST(CheckSurface, OpenInwardAndTurned) {
    SurfaceMesh open = box_surface(unit_box);
    open.triangles = open.triangles.leftCols(11).eval();
    SurfaceReport report = check_surface(open);
    EXPECT_FALSE(report.closed);
    EXPECT_EQ(report.open_edges, 3);
    EXPECT_FALSE(report.outward);

    report = check_surface(flipped(box_surface(unit_box)));
    EXPECT_TRUE(report.closed && report.oriented);
    EXPECT_FALSE(report.outward);
    EXPECT_LT(report.volume, 0.0);

    SurfaceMesh turned = box_surface(unit_box);
    std::swap(turned.triangles(0, 4), turned.triangles(1, 4));
    EXPECT_FALSE(check_surface(turned).oriented);
}

TEST(CheckSurface, TwoBoxesSharingAnEdgeOrACornerAreNotManifold) {
    const SurfaceMesh edge = weld(
        test::together(box_surface(unit_box), box_surface({{0.01, 0.01, 0}, {0.02, 0.02, 0.01}})));
    EXPECT_TRUE(check_surface(edge).closed);
    EXPECT_FALSE(check_surface(edge).manifold);
    const SurfaceMesh corner = weld(
        test::together(box_surface(unit_box), box_surface({{0.01, 0.01, 0.01}, {0.02, 0.02, 0.02}})));
    EXPECT_EQ(check_surface(corner).crowded_edges, 0);
    EXPECT_FALSE(check_surface(corner).manifold);
}

TEST(CheckSurface, WrongUnitIsNamed) {
    EXPECT_FALSE(check_plausible_size({0.1, 12.0, 0.1}));
    EXPECT_FALSE(check_plausible_size({1e-4, 9e-4, 1e-4}));
    EXPECT_TRUE(check_plausible_size({1e-4, 2e-3, 1e-4}));
    const SurfaceReport report = check_surface(box_surface({{0, 0, 0}, {100, 30, 30}}));
    EXPECT_FALSE(report.plausible);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].find("unit"), std::string::npos);
}

TEST(SelfIntersections, CrossingBoxesAreFound) {
    const SurfaceMesh crossing = test::together(box_surface(unit_box),
                                                box_surface({{0.004, 0.003, 0.002}, {0.03, 0.007, 0.006}}));
    const SurfaceReport report = check_surface(crossing);
    EXPECT_GT(report.self_intersections, 3);
    EXPECT_FALSE(report.intersecting_pairs.empty());
    for (const auto& [a, b] : report.intersecting_pairs) EXPECT_TRUE(a < 12 && b >= 12);
    const SurfaceMesh apart = test::together(box_surface(unit_box), box_surface({{0.02, 0, 0}, {0.03, 0.01, 0.01}}));
    EXPECT_EQ(check_surface(apart).self_intersections, 0);
}

TEST(SelfIntersections, OverlapInOnePlaneAndFoldsAreFound) {
    // Two boxes that share a part of a face plane.
    const SurfaceMesh stacked = test::together(box_surface(unit_box),
                                               box_surface({{0.003, 0.003, 0.01}, {0.006, 0.006, 0.02}}));
    EXPECT_GT(check_surface(stacked).self_intersections, 0);

    SurfaceMesh fold;  // the second triangle lies on the first and shares an edge
    fold.vertices.resize(3, 4);
    fold.vertices << 0, 1, 0, 0.3, 0, 0, 1, 0.5, 0, 0, 0, 0;
    fold.triangles.resize(3, 2);
    fold.triangles << 0, 1, 1, 0, 2, 3;
    EXPECT_EQ(self_intersections(fold, 1e-9).size(), 1u);
    fold.vertices(1, 3) = -0.5;  // unfolded: an ordinary neighbour
    EXPECT_TRUE(self_intersections(fold, 1e-9).empty());
}

TEST(SelfIntersections, FastOnThirtyThousandTriangles) {
    const SurfaceMesh ball = weld(test::sphere(6, 0.05));
    ASSERT_EQ(ball.triangles.cols(), 32768);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(check_surface(ball).self_intersections, 0);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 2.0);

    SurfaceMesh second = ball;
    second.vertices.row(0).array() += 0.06;
    const auto pairs = self_intersections(test::together(ball, second), 1e-9);
    EXPECT_GT(pairs.size(), 100u);
    for (const auto& [a, b] : pairs) EXPECT_TRUE(a < 32768 && b >= 32768);
}

TEST(Weld, ClosesASoupAndDropsWhatIsLeftOver) {
    const SurfaceMesh box = box_surface(unit_box);
    SurfaceMesh soup = test::unwelded(box);
    EXPECT_FALSE(surface_topology(soup).closed);
    for (Eigen::Index v = 0; v < soup.vertices.cols(); ++v) soup.vertices(0, v) += 1e-10 * static_cast<double>(v % 3);
    // a repeated triangle, one without extent, and a vertex nobody uses
    soup.triangles.conservativeResize(3, 14);
    soup.triangles.col(12) << soup.triangles(1, 4), soup.triangles(2, 4), soup.triangles(0, 4);
    soup.triangles.col(13) << 0, 0, 5;
    soup.vertices.conservativeResize(3, soup.vertices.cols() + 1);
    soup.vertices.rightCols(1).setConstant(0.005);
    const SurfaceMesh welded = weld(soup);
    EXPECT_EQ(welded.vertices.cols(), 8);
    EXPECT_EQ(welded.triangles.cols(), 12);
    EXPECT_TRUE(check_surface(welded).meshable());
}

TEST(Weld, ZeroToleranceJoinsEqualPointsOnly) {
    const SurfaceMesh soup = test::unwelded(box_surface(unit_box));
    EXPECT_EQ(weld(soup, 0.0).vertices.cols(), 8);
}

TEST(RealGeometry, AllFilesAreClosedAndOutward) {
    const std::vector<std::filesystem::path> bodies = test::shared_bodies();
    if (bodies.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& path : bodies) {
        const auto surface = read_surface(path, 1e-3);
        ASSERT_TRUE(surface) << surface.error().text();
        const SurfaceReport report = check_surface(weld(*surface));
        EXPECT_TRUE(report.closed && report.manifold && report.oriented && report.outward && report.plausible) << path;
        EXPECT_EQ(report.self_intersections, 0) << path;
    }
}

}  // namespace
}  // namespace myo::mesh
