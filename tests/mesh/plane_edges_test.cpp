#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/contour_fill.hpp"
#include "mesh/plane_cut.hpp"
#include "mesh/short_edges.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/test_surfaces.hpp"

// Steps of conforming meshes: vertices moved into a plane, short edges that a cut leaves, sections that are filled.

namespace myo::mesh::plane_edges_test {
namespace {

using Edges = std::vector<std::pair<int, int>>;

const Box all_space{{-9, -9, -9}, {9, 9, 9}};

TEST(SnappedToPlane, MovesNearVerticesAlongTheAxisOnly) {
    const SurfaceMesh cube = box_surface({{0, 0, 0}, {1, 1, 1}});
    for (int axis = 0; axis < 3; ++axis) {
        const SurfaceMesh moved = snapped_to_plane(cube, {axis, 1.05}, 0.06);
        for (Eigen::Index v = 0; v < 8; ++v) {
            Eigen::Vector3d expected = cube.vertices.col(v);
            if (expected[axis] == 1.0) expected[axis] = 1.05;
            EXPECT_EQ(moved.vertices.col(v), expected);
        }
        EXPECT_EQ(moved.triangles, cube.triangles);
    }
    EXPECT_EQ(snapped_to_plane(cube, {0, 1.05}, 0.04).vertices, cube.vertices) << "too far";
    EXPECT_EQ(snapped_to_plane(cube, {0, 1.0}, 0.5).vertices, cube.vertices) << "already there";
}

/// A tenth of the shortest edge at a vertex is the most, so that no triangle turns over.
TEST(SnappedToPlane, IsLimitedByTheShortestEdge) {
    const SurfaceMesh flat = box_surface({{0, 0, 0}, {1, 1, 0.2}});
    EXPECT_EQ(snapped_to_plane(flat, {0, 1.0 + 0.019}, 1.0).vertices.row(0).maxCoeff(), 1.0 + 0.019);
    EXPECT_EQ(snapped_to_plane(flat, {0, 1.0 + 0.021}, 1.0).vertices, flat.vertices);
}

/// A bar cut in the middle: the diagonals of its faces cross the plane 10 mm from its edges.
TEST(ShortEdges, OfACutAreCollapsedOntoIt) {
    const SurfaceMesh bar_surface = box_surface({{0, 0, 0}, {0.1, 0.02, 0.02}});
    const SurfaceMesh cut = cut_by_plane(bar_surface, {0, 0.05}, all_space);
    ASSERT_EQ(cut.vertices.cols(), 8 + 8) << "four edges and four diagonals";
    const SurfaceMesh kept = without_short_edges(cut, {{{0.05}, {}, {}}}, 0.03, 1e-4);
    const SurfaceTopology topology = surface_topology(kept);
    EXPECT_TRUE(topology.closed && topology.manifold && topology.oriented);
    EXPECT_NEAR(enclosed_volume(kept), 4e-5, 1e-18) << "only collapses within faces";
    EXPECT_EQ(kept.vertices.cols(), 12) << "crossings of diagonals join those of edges";
    EXPECT_EQ((kept.vertices.row(0).array() == 0.05).count(), 4);
    // Edges of 10 mm are not short beside cells of 15 mm.
    EXPECT_EQ(without_short_edges(cut, {{{0.05}, {}, {}}}, 0.015, 1e-4).vertices.cols(), 16);
    // Away from planes no vertex is a target.
    const SurfaceMesh elsewhere = without_short_edges(cut, {}, 0.03, 1e-4);
    EXPECT_EQ(elsewhere.vertices, cut.vertices);
    EXPECT_EQ(elsewhere.triangles, cut.triangles);
}

/// Neighbours on the ring of this cut are 0.096 mm off each other's facets, crossings of diagonals 0.031 mm.
TEST(ShortEdges, KeepTheShapeWithinTheDeviation) {
    const SurfaceMesh tube = test::cylinder(64, 0.01, 0.04);
    const SurfaceMesh cut = cut_by_plane(tube, {2, 0.013}, all_space);
    const GridPlanes planes{{{}, {}, {0.013}}};
    const double before = enclosed_volume(tube);
    for (const double deviation : {1e-9, 1e-5, 1e-4}) {
        const SurfaceMesh kept = without_short_edges(cut, planes, 0.008, deviation);
        const SurfaceTopology topology = surface_topology(kept);
        EXPECT_TRUE(topology.closed && topology.manifold && topology.oriented) << deviation;
        if (deviation < 3e-5) {
            EXPECT_EQ(kept.vertices.cols(), 3 * 64) << "both rims and the ring";
            EXPECT_NEAR(enclosed_volume(kept), before, 1e-12 * before) << "only within facets";
        } else {
            EXPECT_LT(kept.vertices.cols(), 3 * 64);
            EXPECT_LT(enclosed_volume(kept), before);
            EXPECT_GT(enclosed_volume(kept), 0.98 * before);
        }
        for (const auto& x : kept.vertices.colwise())
            EXPECT_EQ((cut.vertices.colwise() - x).colwise().norm().minCoeff(), 0.0) << "a vertex goes onto another";
    }
}

/// Polygons in a plane, one after the other; each runs as its points are given.
struct Contours {
    std::vector<Eigen::Vector2d> points;
    Edges edges;

    void add(const std::vector<Eigen::Vector2d>& polygon) {
        const int first = static_cast<int>(points.size()), count = static_cast<int>(polygon.size());
        points.insert(points.end(), polygon.begin(), polygon.end());
        for (int i = 0; i < count; ++i) edges.emplace_back(first + i, first + (i + 1) % count);
    }
    /// Square around a centre; a hole runs clockwise.
    void add_square(const Eigen::Vector2d& centre, double half, bool hole = false) {
        const Eigen::Vector2d x(half, 0), y(0, half);
        if (hole)
            add({centre - x - y, centre - x + y, centre + x + y, centre + x - y});
        else
            add({centre - x - y, centre + x - y, centre + x + y, centre - x + y});
    }
    /// Places in space: the plane of `axis` at 0.3, seen against the axis or, turned, along it.
    Eigen::Matrix3Xd places(int axis, double sign) const {
        Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(points.size()));
        for (std::size_t v = 0; v < points.size(); ++v) {
            Eigen::Vector3d place = Eigen::Vector3d::Constant(0.3);
            place[(axis + 1) % 3] = points[v][0];
            place[(axis + 2) % 3] = sign * points[v][1];
            x.col(static_cast<Eigen::Index>(v)) = place;
        }
        return x;
    }
};

/// Area along a normal; every triangle must face that way.
double filled_area(const Contours& contours, int axis, double sign) {
    const Eigen::Matrix3Xd x = contours.places(axis, sign);
    const Eigen::Vector3d normal = sign * Eigen::Vector3d::Unit(axis);
    const auto filled = fill_contours(x, contours.edges, normal);
    if (!filled) {
        ADD_FAILURE() << filled.error().text();
        return 0.0;
    }
    double area = 0.0;
    for (const auto& [a, b, c] : *filled) {
        const double
            own = 0.5 * (Eigen::Vector3d(x.col(b)) - x.col(a)).cross(Eigen::Vector3d(x.col(c)) - x.col(a)).dot(normal);
        EXPECT_GT(own, 0.0);
        area += own;
    }
    return area;
}

TEST(FillContours, HaveTheirAreaAlongEveryAxisAndAgainstIt) {
    Contours contours;
    contours.add_square({0, 0}, 4.0);                             // 64
    contours.add_square({0.5, 0.25}, 3.0, true);                  // a hole of 36
    contours.add_square({0.25, 0.5}, 2.0);                        // an island of 16 in it
    contours.add_square({0.125, 0.0625}, 0.5, true);              // with a hole of 1
    contours.add({{10, 0}, {12, 0}, {11, 1}, {12, 2}, {10, 2}});  // beside all that, with a notch: 3
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) EXPECT_NEAR(filled_area(contours, axis, sign), 46.0, 1e-12) << axis;
}

/// Several bridges start at one vertex then: each must leave it on the side of the area. In rows and aside.
TEST(FillContours, GoRoundManyHoles) {
    for (const double aside : {0.0, 0.1}) {
        Contours contours;
        contours.add_square({0, 0}, 5.0);
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                contours.add_square({3.0 * i + aside * j, 3.0 * j + 0.7 * aside * i}, 1.0, true);
        EXPECT_NEAR(filled_area(contours, 2, 1.0), 100.0 - 9.0 * 4.0, 1e-12) << aside;
    }
}

/// Points in the middle of straight sides are no corners, but belong to the triangles.
TEST(FillContours, UseEveryPointOfStraightSides) {
    Contours contours;
    contours.add({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    const Eigen::Matrix3Xd x = contours.places(2, 1.0);
    const auto filled = fill_contours(x, contours.edges, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(filled);
    EXPECT_EQ(filled->size(), 8u) << "two less than points";
    std::set<int> used;
    for (const auto& triangle : *filled) used.insert(triangle.begin(), triangle.end());
    EXPECT_EQ(used.size(), 10u);
    EXPECT_NEAR(filled_area(contours, 2, 1.0), 6.0, 1e-13);
}

TEST(FillContours, RefuseWhatIsNoSection) {
    const auto refused = [](const Contours& contours) {
        const auto filled = fill_contours(contours.places(2, 1.0), contours.edges, Eigen::Vector3d::UnitZ());
        return !filled && filled.error().what == "a section has contours that are open or cross";
    };
    Contours hole_alone, bow, turned_bow, open, hole_outside;
    hole_alone.add_square({0, 0}, 1.0, true);
    EXPECT_TRUE(refused(hole_alone)) << "runs clockwise around nothing";
    bow.add({{0, 0}, {4, 4}, {4, 0}, {0, 3}});
    EXPECT_TRUE(refused(bow)) << "crosses itself, the larger part clockwise";
    turned_bow.add({{0, 3}, {4, 0}, {4, 4}, {0, 0}});
    EXPECT_TRUE(refused(turned_bow)) << "the larger part counter-clockwise";
    open.add_square({0, 0}, 1.0);
    open.edges.pop_back();
    EXPECT_TRUE(refused(open));
    hole_outside.add_square({0, 0}, 1.0);
    hole_outside.add_square({5, 0}, 0.5, true);
    EXPECT_TRUE(refused(hole_outside));
}

}  // namespace
}  // namespace myo::mesh::plane_edges_test
