#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mesh/boundary_surface.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/plane_cut.hpp"
#include "mesh/polygon.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/winding_number.hpp"

namespace myo::mesh {
namespace {

/// Vertices - edges + triangles.
int euler_characteristic(const SurfaceMesh& surface) {
    std::set<std::array<int, 2>> edges;
    std::set<int> vertices;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
        for (Eigen::Index i = 0; i < 3; ++i) {
            const int a = surface.triangles(i, t), b = surface.triangles((i + 1) % 3, t);
            edges.insert({std::min(a, b), std::max(a, b)});
            vertices.insert(a);
        }
    return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
           static_cast<int>(surface.triangles.cols());
}

/// A square ring of 3 x 3 x 1 cubes without the one in the middle.
VolumeMesh ring() {
    VolumeMesh mesh = box_hex_mesh({{0.0, 0.0, 0.0}, {3.0, 3.0, 1.0}}, {3, 3, 1});
    const Eigen::MatrixXi all = mesh.cells;
    mesh.cells.resize(8, 8);
    for (Eigen::Index c = 0, kept = 0; c < 9; ++c)
        if (c != 4) mesh.cells.col(kept++) = all.col(c);
    return mesh;
}

TEST(EulerCharacteristic, IsTwoForEveryBodyWithoutHoles) {
    EXPECT_EQ(euler_characteristic(box_surface({{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}})), 2);
    EXPECT_EQ(euler_characteristic(weld(test::sphere(2, 1.0))), 2);
    EXPECT_EQ(euler_characteristic(test::l_shape()), 2);
    for (const VolumeMesh& mesh : test::one_of_each()) EXPECT_EQ(euler_characteristic(boundary_surface(mesh)), 2);
}

TEST(EulerCharacteristic, IsZeroForARing) {
    const SurfaceMesh surface = boundary_surface(ring());
    EXPECT_EQ(euler_characteristic(surface), 0);
    const SurfaceTopology topology = surface_topology(surface);
    EXPECT_TRUE(topology.closed && topology.manifold && topology.oriented);
    EXPECT_EQ(topology.parts, 1);
    EXPECT_NEAR(enclosed_volume(surface), 8.0, 1e-12);
}

TEST(SurfaceTopology, CountsPartsAndFaults) {
    const SurfaceMesh box = box_surface({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
    const SurfaceMesh two = test::together(box, box_surface({{2.0, 0.0, 0.0}, {3.0, 1.0, 1.0}}));
    const SurfaceTopology parts = surface_topology(two);
    EXPECT_EQ(parts.parts, 2);
    EXPECT_EQ(std::count(parts.part.begin(), parts.part.end(), parts.part.front()), 12);
    SurfaceMesh open = box;
    open.triangles.conservativeResize(3, 11);
    EXPECT_FALSE(surface_topology(open).closed);
    EXPECT_EQ(surface_topology(open).open_edges, 3);
    SurfaceMesh turned = box;
    std::swap(turned.triangles(0, 5), turned.triangles(1, 5));
    EXPECT_TRUE(surface_topology(turned).closed);
    EXPECT_FALSE(surface_topology(turned).oriented);
    EXPECT_EQ(surface_topology(turned).turned_edges, 3);
}

TEST(EnclosedVolume, HasClosedFormsAndScalesWithTheCube) {
    EXPECT_NEAR(enclosed_volume(box_surface({{-1.0, 2.0, 0.5}, {1.0, 5.0, 1.0}})), 3.0, 1e-14);
    EXPECT_NEAR(enclosed_volume(test::l_shape()), 3e-6, 1e-20);
    // Prism over a regular polygon: n/2 r^2 sin(2 pi / n) h.
    EXPECT_NEAR(enclosed_volume(test::cylinder(12, 0.5, 2.0)), 2.0 * 6.0 * 0.25 * 0.5, 1e-14);
    SurfaceMesh inward = test::sphere(1, 1.0);
    const double outward = enclosed_volume(inward);
    inward.triangles.row(0).swap(inward.triangles.row(1));
    EXPECT_NEAR(enclosed_volume(inward), -outward, 1e-14);
    inward.vertices *= 2.0;
    EXPECT_NEAR(enclosed_volume(inward), -8.0 * outward, 1e-13);
    inward.vertices.colwise() += Eigen::Vector3d(5.0, -3.0, 1.0);
    EXPECT_NEAR(enclosed_volume(inward), -8.0 * outward, 1e-12);
}

TEST(WindingNumber, IsOneInsideAndZeroOutside) {
    const SurfaceMesh shape = test::l_shape();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-0.005, 0.025);
    int inside = 0;
    for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d p(place(random), place(random), place(random));
        const auto in = [](double x, double low, double high) { return x > low && x < high; };
        const bool in_arm = in(p.x(), 0.0, 0.02) && in(p.y(), 0.0, 0.01),
                   in_leg = in(p.x(), 0.0, 0.01) && in(p.y(), 0.0, 0.02);
        const bool expected = in(p.z(), 0.0, 0.01) && (in_arm || in_leg);
        inside += expected;
        ASSERT_NEAR(winding_number(shape, p), expected ? 1.0 : 0.0, 1e-9) << p.transpose();
    }
    EXPECT_GT(inside, 20);
    EXPECT_NEAR(winding_number(test::together(test::sphere(1, 1.0), test::sphere(1, 2.0)), {0.1, 0.2, 0.0}), 2.0,
                1e-12);
    SurfaceMesh inward = test::sphere(1, 1.0);
    inward.triangles.row(0).swap(inward.triangles.row(1));
    EXPECT_NEAR(winding_number(inward, {0.1, -0.2, 0.3}), -1.0, 1e-12);
}

TEST(PlaneCut, KeepsVolumeAndClosureAndMeetsThePlane) {
    const SurfaceMesh body = weld(test::sphere(2, 1.0));
    for (int axis = 0; axis < 3; ++axis) {
        const double at = 0.31 - 0.2 * axis;
        const SurfaceMesh cut = cut_by_plane(body, {axis, at}, {{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}});
        EXPECT_GT(cut.triangles.cols(), body.triangles.cols());
        EXPECT_NEAR(enclosed_volume(cut), enclosed_volume(body), 1e-12);
        EXPECT_TRUE(surface_topology(cut).closed && surface_topology(cut).manifold);
        EXPECT_EQ(euler_characteristic(cut), 2);
        for (Eigen::Index t = 0; t < cut.triangles.cols(); ++t) {
            bool above = false, below = false;
            for (const int v : cut.triangles.col(t)) {
                above = above || cut.vertices(axis, v) > at;
                below = below || cut.vertices(axis, v) < at;
            }
            EXPECT_FALSE(above && below) << t;
        }
    }
    // Nothing is cut where the box does not reach.
    EXPECT_EQ(cut_by_plane(body, {0, 0.31}, {{5.0, 5.0, 5.0}, {6.0, 6.0, 6.0}}).triangles.cols(),
              body.triangles.cols());
}

TEST(Polygons, TrianglesCoverTheirArea) {
    // A comb with reflex corners in a tilted plane.
    const std::vector<Eigen::Vector2d> outline{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                                               {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    const Eigen::Vector3d u = Eigen::Vector3d(1, 2, -1).normalized(),
                          v = u.cross(Eigen::Vector3d(0, 1, 3)).normalized();
    std::vector<Eigen::Vector3d> corners;
    std::vector<int> polygon;
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        polygon.push_back(static_cast<int>(i));
        corners.emplace_back(outline[i].x() * u + outline[i].y() * v);
        const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_EQ(area, 11.0);
    const std::vector<std::array<int, 3>> triangles = triangles_of(polygon, corners);
    EXPECT_EQ(triangles.size(), outline.size() - 2);
    double sum = 0.0;
    for (const std::array<int, 3>& t : triangles) {
        const auto at = [&](std::size_t i) { return corners[static_cast<std::size_t>(t[i])]; };
        const double signed_area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).dot(u.cross(v));
        EXPECT_GE(signed_area, -1e-12);
        sum += signed_area;
    }
    EXPECT_NEAR(sum, area, 1e-12);
    EXPECT_TRUE(triangles_of({0, 1}, corners).empty());
}

TEST(DisjointSets, AreRepresentedByTheirSmallestMember) {
    DisjointSets sets(6);
    sets.join(5, 3);
    sets.join(3, 4);
    sets.join(1, 0);
    EXPECT_EQ(sets.find(5), 3u);
    EXPECT_EQ(sets.find(4), 3u);
    EXPECT_EQ(sets.find(1), 0u);
    EXPECT_EQ(sets.find(2), 2u);
    sets.join(4, 1);
    EXPECT_EQ(sets.find(5), 0u);
    sets.reset(3);
    EXPECT_EQ(sets.find(1), 1u);
}

}  // namespace
}  // namespace myo::mesh
