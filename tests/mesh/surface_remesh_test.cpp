#include "mesh/surface_remesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_distance.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/tet_mesh.hpp"

namespace myo::mesh {
namespace {

constexpr double any_deviation = std::numeric_limits<double>::infinity();

/// Every triangle in four, in its plane.
SurfaceMesh subdivided(SurfaceMesh s, int levels) {
    for (int level = 0; level < levels; ++level) {
        SurfaceMesh fine{Eigen::Matrix3Xd(3, 6 * s.triangles.cols()), Eigen::Matrix3Xi(3, 4 * s.triangles.cols())};
        for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
            const int b = static_cast<int>(6 * t);
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d x = s.vertices.col(s.triangles(i, t)),
                                      y = s.vertices.col(s.triangles((i + 1) % 3, t));
                fine.vertices.col(b + i) = x;
                fine.vertices.col(b + 3 + i) = 0.5 * (x + y);
            }
            fine.triangles.col(4 * t) << b, b + 3, b + 5;
            fine.triangles.col(4 * t + 1) << b + 3, b + 1, b + 4;
            fine.triangles.col(4 * t + 2) << b + 5, b + 4, b + 2;
            fine.triangles.col(4 * t + 3) << b + 3, b + 4, b + 5;
        }
        s = weld(fine);
    }
    return s;
}

void expect_sound(const SurfaceMesh& surface, int parts) {
    const SurfaceReport report = check_surface(surface);
    EXPECT_TRUE(report.meshable() && report.oriented && report.outward);
    EXPECT_EQ(report.components, parts);
}

TEST(SizedSurface, FineSphereTakesTheCellsThatWereAskedFor) {
    const SurfaceMesh fine = weld(test::sphere(5, 0.025));
    const double edge = 0.01;
    const SizedSurface sized = sized_surface(fine, edge, any_deviation);
    ASSERT_TRUE(sized.remeshed);
    ASSERT_EQ(sized.notes.size(), 1u);
    expect_sound(sized.surface, 1);
    EXPECT_LT(sized.deviation_m, remesh_policy.max_deviation * edge);
    EXPECT_GT(sized.deviation_m, 0.0);
    EXPECT_LT(std::abs(sized.volume_change), 2e-3);
    // An inscribed surface of such triangles would lack 3 % of the volume; vertices lie outside of the sphere instead.
    EXPECT_GT(sized.surface.vertices.colwise().norm().minCoeff(), 0.025);
    TetOptions options;
    options.edge = edge;
    const auto mesh = tetrahedralize(sized.surface, options);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_LT(static_cast<double>(mesh->cell_count()), 5.0 * estimate_counts(fine, CellType::tet4, edge).cells);
    EXPECT_GT(mesh_quality(*mesh).least, 0.1);
}

TEST(SizedSurface, CoarseSurfacesStayAsTheyAre) {
    for (const SurfaceMesh& surface : {box_surface(test::unequal_box()), test::cylinder(24, 0.015, 0.06),
                                       test::l_shape(), weld(test::sphere(3, 0.025))}) {
        const SizedSurface sized = sized_surface(surface, 0.008, any_deviation);
        EXPECT_FALSE(sized.remeshed);
        EXPECT_TRUE(sized.notes.empty());
        EXPECT_EQ(sized.surface.vertices, surface.vertices);
        EXPECT_EQ(sized.surface.triangles, surface.triangles);
    }
}

TEST(SizedSurface, FlatBodiesDoNotChange) {
    const SurfaceMesh coarse = test::l_shape(), fine = subdivided(coarse, 4);
    const SizedSurface sized = sized_surface(fine, 0.005, any_deviation);
    ASSERT_TRUE(sized.remeshed);
    expect_sound(sized.surface, 1);
    EXPECT_LT(sized.surface.triangles.cols(), fine.triangles.cols() / 4);
    EXPECT_NEAR(enclosed_volume(sized.surface), enclosed_volume(coarse), 1e-12 * enclosed_volume(coarse));
    EXPECT_LT(sized.deviation_m, 1e-12);
    // Every corner is a vertex, to the last bit.
    for (const auto& corner : coarse.vertices.colwise())
        EXPECT_EQ((sized.surface.vertices.colwise() - corner).colwise().norm().minCoeff(), 0.0);
}

TEST(SizedSurface, EndsOfARoundStayFlatAndRound) {
    const double radius = 0.01, height = 0.06;
    const SurfaceMesh fine = subdivided(test::cylinder(48, radius, height), 1);
    const SizedSurface sized = sized_surface(fine, 0.006, any_deviation);
    ASSERT_TRUE(sized.remeshed);
    expect_sound(sized.surface, 1);
    EXPECT_LT(std::abs(sized.volume_change), remesh_policy.max_volume_change);
    for (const double z : {0.0, height}) {
        double area = 0.0;
        for (const auto& t : sized.surface.triangles.colwise()) {
            const Eigen::Matrix3d X = sized.surface.vertices(Eigen::all, t);
            if ((X.row(2).array() == z).all()) area += 0.5 * (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).norm();
        }
        // The contour keeps its vertices on the circle, so that only the segments behind its edges are missing.
        EXPECT_NEAR(area, std::numbers::pi * radius * radius, 0.12 * std::numbers::pi * radius * radius);
    }
}

TEST(SizedSurface, WallsDoNotMeet) {
    const SurfaceMesh hollow = test::together(weld(test::sphere(5, 0.025)), flipped(weld(test::sphere(5, 0.022))));
    const SizedSurface sized = sized_surface(hollow, 0.008, 0.15 * 0.003);
    ASSERT_TRUE(sized.remeshed);
    expect_sound(sized.surface, 2);
    EXPECT_LT(sized.deviation_m, 0.15 * 0.003);
    // Vertices of both walls keep their distance; the inner ones lie inside of 22 mm plus the deviation.
    for (const auto& x : sized.surface.vertices.colwise())
        EXPECT_TRUE(std::abs(x.norm() - 0.022) < 0.00045 || std::abs(x.norm() - 0.025) < 0.00045) << x.norm();
}

/// Cells larger than the body is thick cannot be had; the surface then becomes as coarse as its shape allows, not as
/// fine as it was drawn.
TEST(SizedSurface, CellsThickerThanTheBodyTakeTheCoarsestSurface) {
    SurfaceMesh slender = weld(test::sphere(5, 0.015));
    slender.vertices.row(2) *= 6.0;
    const double deviation = 1e-3;
    Eigen::Index last = slender.triangles.cols();
    for (const double edge : {0.02, 0.06, 0.2}) {
        const SizedSurface sized = sized_surface(slender, edge, deviation);
        ASSERT_TRUE(sized.remeshed) << edge;
        expect_sound(sized.surface, 1);
        EXPECT_LE(sized.deviation_m, deviation);
        EXPECT_LT(sized.surface.triangles.cols(), slender.triangles.cols() / 4) << edge;
        // Sizes are tried in steps of 0.84, so that two edges may end a step apart.
        EXPECT_LT(sized.surface.triangles.cols(), 3 * last / 2) << edge;
        last = sized.surface.triangles.cols();
    }
}

TEST(SizedSurface, WhatCannotBeCoarsenedIsKeptAndTold) {
    SurfaceMesh rough = weld(test::sphere(4, 0.025));
    // Every second vertex a spike: all edges are sharp.
    for (Eigen::Index v = 0; v < rough.vertices.cols(); v += 2) rough.vertices.col(v) *= 1.12;
    const SizedSurface sized = sized_surface(rough, 0.012, 1e-4);
    EXPECT_FALSE(sized.remeshed);
    EXPECT_EQ(sized.surface.vertices, rough.vertices);
    ASSERT_EQ(sized.notes.size(), 1u);
    EXPECT_NE(sized.notes[0].find("2048 triangles fix the size of the cells: about 20000 tetrahedra"),
              std::string::npos)
        << sized.notes[0];
}

TEST(SizedSurface, IsRepeatable) {
    const SurfaceMesh fine = weld(test::sphere(4, 0.025));
    const SizedSurface a = sized_surface(fine, 0.012, any_deviation), b = sized_surface(fine, 0.012, any_deviation);
    ASSERT_TRUE(a.remeshed);
    EXPECT_EQ(a.surface.vertices, b.surface.vertices);
    EXPECT_EQ(a.surface.triangles, b.surface.triangles);
}

TEST(SurfaceDistance, NearestPointsOfABox) {
    const SurfaceDistance box(box_surface({{0, 0, 0}, {1, 1, 1}}));
    EXPECT_NEAR(box.nearest({0.3, 0.4, 0.1}).distance, 0.1, 1e-15);
    EXPECT_NEAR((box.nearest({2.0, 0.5, 0.25}).point - Eigen::Vector3d(1, 0.5, 0.25)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(box.nearest({2, 2, 0.5}).distance, std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(box.nearest({2, 2, -1}).distance, std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(box.largest_from(box_surface({{0, 0, 0}, {1, 1, 1.5}})), 0.5, 1e-15);
}

}  // namespace
}  // namespace myo::mesh
