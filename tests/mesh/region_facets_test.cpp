#include "mesh/region_facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/contour_fill.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/tet_mesh.hpp"
#include "support/shared_data.hpp"

namespace myo::mesh {
namespace {

constexpr double far_away = 1.0;

/// Below x_axis = at, and beyond the body elsewhere.
Box below(int axis, double at) {
    Box box{Eigen::Vector3d::Constant(-far_away), Eigen::Vector3d::Constant(far_away)};
    box.highest(axis) = at;
    return box;
}

struct Allowed {
    double volume = 1e-9;  // relative
    double growth = 2.0;   // of the number of nodes against a mesh that ignores the regions
};

/// Cells lie wholly in or out of every region, and fill the body.
void expect_conforming(const SurfaceMesh& surface, const std::vector<Box>& regions, double edge,
                       const Allowed& allowed = {}) {
    TetOptions options;
    options.edge = edge;
    options.regions = regions;
    const auto mesh = tetrahedralize(surface, options);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const Eigen::VectorXd volumes = cell_volumes(*mesh);
    const double volume = volumes.sum();
    EXPECT_GT(volumes.minCoeff(), 0.0);
    EXPECT_NEAR(volume / enclosed_volume(surface), 1.0, allowed.volume);
    for (const Box& region : regions) {
        const Eigen::VectorXd inside = volume_fractions(*mesh, region);
        for (Eigen::Index c = 0; c < inside.size(); ++c)
            EXPECT_LT(std::min(inside(c), 1.0 - inside(c)) * volumes(c), 1e-9 * volume)
                << "cell " << c << " is cut, " << inside(c);
        EXPECT_GT(inside.sum(), 0.0);
        // The nodes of the cells inside are those that a clamp of this box finds.
        std::vector<bool> found(static_cast<std::size_t>(mesh->node_count()), false);
        for (const int node : nodes_in_box(*mesh, region)) found[static_cast<std::size_t>(node)] = true;
        for (Eigen::Index c = 0; c < inside.size(); ++c)
            for (int i = 0; inside(c) > 0.5 && i < 4; ++i)
                EXPECT_TRUE(found[static_cast<std::size_t>(mesh->cells(i, c))]);
    }
    // Cutting must not cost many cells: short edges at the section would.
    options.regions.clear();
    const auto plain = tetrahedralize(surface, options);
    ASSERT_TRUE(plain);
    EXPECT_LT(static_cast<double>(mesh->node_count()), allowed.growth * static_cast<double>(plain->node_count()))
        << "against " << plain->node_count();
    EXPECT_GT(mesh_quality(*mesh).least, 0.02);
}

const Box bar{{0, 0, 0}, {0.125, 0.02, 0.02}};

TEST(RegionFacets, LeaveABodyAsItIsWhereNothingCutsIt) {
    const SurfaceMesh surface = box_surface(bar);
    for (const std::vector<Box>& regions :
         {std::vector<Box>{}, {below(0, 0.0)}, {below(0, -0.01)}, {below(0, 0.1249)}, {below(1, 0.3)}}) {
        const auto facets = region_facets(surface, regions, 0.01);
        ASSERT_TRUE(facets);
        EXPECT_EQ(facets->surface.vertices, surface.vertices);
        EXPECT_EQ(facets->surface.triangles, surface.triangles);
        EXPECT_EQ(facets->inner.cols(), 0);
    }
}

TEST(RegionFacets, CutABarCleanly) {
    const auto facets = region_facets(box_surface(bar), {below(0, 0.025)}, 0.009);
    ASSERT_TRUE(facets);
    const SurfaceTopology topology = surface_topology(facets->surface);
    EXPECT_TRUE(topology.closed && topology.manifold && topology.oriented);
    EXPECT_NEAR(enclosed_volume(facets->surface), 5e-5, 1e-18);
    EXPECT_EQ(facets->surface.vertices.cols(), 12) << "the diagonals' crossings are joined with the corners'";
    EXPECT_EQ(facets->inner.cols(), 2);
    for (const int v : facets->inner.reshaped()) EXPECT_EQ(facets->surface.vertices(0, v), 0.025);
}

TEST(RegionFacets, MeetDeepClamps) {
    for (const double depth : {0.002, 0.0152, 0.025, 0.03})
        expect_conforming(box_surface(bar), {below(0, depth)}, 0.009);
    // A slice of an eighth of an edge takes small cells.
    expect_conforming(box_surface(bar), {below(0, 0.1239)}, 0.009, {.growth = 3.0});
}

TEST(RegionFacets, MeetSeveralPlanesAndSmallBoxes) {
    const SurfaceMesh surface = box_surface(bar);
    expect_conforming(surface, {below(0, 0.02), below(0, 0.09)}, 0.008);
    expect_conforming(surface, {{{0.02, -far_away, -far_away}, {0.05, far_away, 0.012}}}, 0.008);
    expect_conforming(surface, {{{0.03, 0.005, 0.006}, {0.05, 0.014, 0.015}}}, 0.008);  // wholly inside
    expect_conforming(surface, {below(0, 0.02), {{0.01, 0.01, -far_away}, {0.05, far_away, far_away}}},
                      0.008);  // overlapping
}

TEST(RegionFacets, MeetCurvedSurfaces) {
    for (const double at : {0.002, 0.031, 0.0583})
        expect_conforming(test::cylinder(24, 0.015, 0.06), {below(2, at)}, 0.006);
    expect_conforming(test::cylinder(24, 0.015, 0.06), {below(0, 0.004)}, 0.006, {.volume = 1e-3});
    const SurfaceMesh ball = weld(test::sphere(3, 0.02));
    // Uncut, its angles are bounded weakly, see angle_policy: 280 nodes, of which 258 are the surface's.
    for (const double at : {-0.01, 0.0, 0.0023})
        expect_conforming(ball, {below(0, at)}, 0.006, {.volume = 1e-3, .growth = 6.0});
    expect_conforming(ball, {{{-0.01, -0.012, 0.003}, {0.011, 0.2, 0.2}}}, 0.006, {.volume = 1e-3, .growth = 6.0});
}

TEST(RegionFacets, MeetFacesThatLieInThePlaneOrNearIt) {
    const SurfaceMesh l = test::l_shape();  // its inner faces lie at 0.01
    for (const double at : {0.01, 0.01 + 1e-9, 0.01 - 2e-5})
        expect_conforming(l, {below(0, at)}, 0.004, {.volume = 1e-3});
    expect_conforming(l, {{{-far_away, -far_away, -far_away}, {0.01, 0.01, 0.005}}}, 0.004);
}

/// A box that ends a hair inside the body's bounds ends there: the section is filled to the surface.
TEST(RegionFacets, ReachTheSurfaceWhereABoxNearlyDoes) {
    const auto facets = region_facets(box_surface(bar), {{{-1, -1, -1}, {0.03, 0.0198, 0.0199}}}, 0.009);
    ASSERT_TRUE(facets) << facets.error().text();
    double area = 0.0;
    for (Eigen::Index t = 0; t < facets->inner.cols(); ++t) {
        const auto corner = [&](int i) -> Eigen::Vector3d { return facets->surface.vertices.col(facets->inner(i, t)); };
        area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).x();
    }
    EXPECT_NEAR(area, 4e-4, 1e-12);
}

TEST(RegionFacets, GoAroundCavities) {
    const SurfaceMesh hollow = test::together(box_surface({{0, 0, 0}, {0.04, 0.04, 0.04}}),
                                              flipped(box_surface({{0.01, 0.01, 0.01}, {0.03, 0.03, 0.03}})));
    for (const double at : {0.005, 0.01, 0.02, 0.03}) expect_conforming(hollow, {below(0, at)}, 0.008);
    expect_conforming(hollow, {{{-far_away, -far_away, -far_away}, {0.02, 0.02, 0.02}}}, 0.008);
}

TEST(RegionFacets, MeetRealGeometry) {
    const std::vector<std::filesystem::path> bodies = test::shared_bodies();
    if (bodies.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& path : bodies) {
        SCOPED_TRACE(path.filename().string());
        const SurfaceMesh surface = weld(*read_surface(path, 1e-3));
        const Box bounds = bounding_box(surface.vertices);
        Eigen::Index axis = 0;
        bounds.size().maxCoeff(&axis);
        const double edge = std::cbrt(enclosed_volume(surface)) / 3.0;
        for (const double part : {0.1, 0.237})
            expect_conforming(surface,
                              {below(static_cast<int>(axis), bounds.lowest(axis) + part * bounds.size()(axis))}, edge,
                              {.volume = 1e-3});
    }
}

TEST(FillContours, FillsNestedOnesAndRefusesOpenOnes) {
    Eigen::Matrix3Xd x(3, 8);
    x << 0, 3, 3, 0, 1, 2, 2, 1, 0, 0, 3, 3, 1, 1, 2, 2, 5, 5, 5, 5, 5, 5, 5, 5;
    std::vector<std::pair<int, int>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 7}, {7, 6}, {6, 5}, {5, 4}};
    const auto filled = fill_contours(x, edges, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(filled) << filled.error().text();
    EXPECT_EQ(filled->size(), 8u);
    edges.erase(edges.begin() + 1);
    EXPECT_FALSE(fill_contours(x, edges, Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(fill_contours(x, {}, Eigen::Vector3d::UnitZ())->empty());
}

}  // namespace
}  // namespace myo::mesh
