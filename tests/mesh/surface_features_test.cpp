#include "mesh/surface_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/isotropic_remesh.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_distance.hpp"
#include "mesh/test_surfaces.hpp"

// Lines of a surface that remeshing keeps: sharp edges, contours of flat faces, and where these lines must not move.

namespace myo::mesh::surface_features_test {
namespace {

constexpr double whatever = std::numeric_limits<double>::infinity();
/// An edge length beside which no face is broad, and one beside which every face is.
constexpr double long_edge = 1e3, short_edge = 1e-3;

using Line = std::pair<int, int>;

/// Two triangles on the edge from vertex 0 to 1, with so much between their normals.
SurfaceMesh roof(double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    SurfaceMesh surface{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
    surface.vertices << 0, 0, -1, std::cos(angle), 0, 1, 0.5, 0.5, 0, 0, 0, std::sin(angle);
    surface.triangles << 0, 1, 1, 0, 2, 3;
    return surface;
}

TEST(FeatureLines, BeginAtTheirAngles) {
    const std::vector<Line> ridge{{0, 1}};
    EXPECT_TRUE(feature_lines(roof(feature_policy.sharp_deg - 0.01), long_edge, whatever).edges.empty());
    EXPECT_EQ(feature_lines(roof(feature_policy.sharp_deg + 0.01), long_edge, whatever).edges, ridge);
    EXPECT_EQ(feature_lines(roof(-feature_policy.sharp_deg - 0.01), long_edge, whatever).edges, ridge) << "a valley";
    EXPECT_EQ(feature_lines(roof(170.0), long_edge, whatever).edges, ridge);
    // Between broad faces a smaller angle is a contour, unless rounding may have made it.
    EXPECT_TRUE(feature_lines(roof(feature_policy.flat_deg - 0.01), short_edge, whatever).edges.empty());
    EXPECT_EQ(feature_lines(roof(feature_policy.flat_deg + 0.01), short_edge, whatever).edges, ridge);
    EXPECT_EQ(feature_lines(roof(90.0), long_edge, whatever).corners, (std::vector<int>{0, 1})) << "the ends stay";
}

/// Each wing of the roof has 0.5 m2 and one edge of 1 m that it shares: its breadth is 2 m.
TEST(FeatureLines, FacesAreBroadFromTheEdgeOn) {
    const double breadth = 2.0 / feature_policy.face_breadth;
    EXPECT_EQ(feature_lines(roof(10.0), breadth - 1e-6, whatever).edges.size(), 1u);
    EXPECT_EQ(feature_lines(roof(10.0), breadth + 1e-6, whatever).edges.size(), 0u);
}

TEST(FeatureLines, TrianglesWithoutAreaMakeNone) {
    SurfaceMesh surface = roof(90.0);
    surface.vertices.col(3) << 0.0, 0.5, 0.0;  // on the ridge
    EXPECT_TRUE(feature_lines(surface, short_edge, whatever).edges.empty());
    EXPECT_TRUE(feature_lines(surface, long_edge, whatever).edges.empty());
}

/// A prism over n corners has 3 n edges and 2 n corners, whatever the triangles of its faces.
TEST(FeatureLines, OfPrismsAreTheirEdges) {
    for (const double edge : {short_edge, long_edge}) {
        const FeatureLines of_box = feature_lines(box_surface({{0, 0, 0}, {1, 2, 3}}), edge, whatever);
        EXPECT_EQ(of_box.edges.size(), 12u);
        EXPECT_EQ(of_box.corners.size(), 8u);
        EXPECT_TRUE(std::is_sorted(of_box.edges.begin(), of_box.edges.end()));
        for (const auto& [low, high] : of_box.edges) EXPECT_LT(low, high);
        const FeatureLines of_l = feature_lines(test::l_shape(), edge, whatever);
        EXPECT_EQ(of_l.edges.size(), 18u) << "the inner edge as well";
        EXPECT_EQ(of_l.corners.size(), 12u);
        // Eleven sides turn by 33 degrees each: edges of the body.
        EXPECT_EQ(feature_lines(test::cylinder(11, 1.0, 2.0), edge, whatever).edges.size(), 33u);
    }
}

/// Sixteen sides turn by 22.5 degrees. Their breadth is 2 w h / (w + h) = 0.65 m for r = 1 m and h = 2 m.
TEST(FeatureLines, FacetsOfARoundAreNoFaces) {
    const SurfaceMesh tube = test::cylinder(16, 1.0, 2.0);
    const FeatureLines as_round = feature_lines(tube, 0.66, whatever), as_facets = feature_lines(tube, 0.64, whatever);
    EXPECT_EQ(as_round.edges.size(), 32u) << "both rims";
    EXPECT_EQ(as_facets.edges.size(), 48u);
    EXPECT_EQ(as_facets.corners.size(), 32u);
    // A rim bends nowhere by 30 degrees: one vertex of each holds it.
    EXPECT_EQ(as_round.corners, (std::vector<int>{0, 16}));
}

/// Distance of a point from the straight line between two others.
double off_line(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (x - nearest_in_segment(a, b, x)).norm();
}

TEST(FeatureLines, BentOnesKeepWhatTheDeviationAsksFor) {
    const int sides = 48;
    const SurfaceMesh tube = test::cylinder(sides, 1.0, 2.0);
    std::size_t before = 0;
    for (const double deviation : {0.5, 0.1, 0.02, 0.0}) {
        const FeatureLines lines = feature_lines(tube, 1.0, deviation);
        const std::set<int> corners(lines.corners.begin(), lines.corners.end());
        for (const int rim : {0, sides}) {
            const int start = *corners.lower_bound(rim);
            int last = start;
            for (int k = 1; k <= sides; ++k) {
                const int v = rim + (start - rim + k) % sides;
                if (!corners.contains(v)) continue;
                for (int skipped = last; skipped != v; skipped = rim + (skipped - rim + 1) % sides)
                    EXPECT_LE(off_line(tube.vertices.col(skipped), tube.vertices.col(last), tube.vertices.col(v)),
                              deviation + 1e-12);
                last = v;
            }
        }
        EXPECT_GT(corners.size(), before) << deviation;
        before = corners.size();
    }
    EXPECT_EQ(before, 2u * sides) << "all of them if nothing may be off";
}

double length_of(const RemeshedSurface& remeshed) {
    double length = 0.0;
    for (const auto& [a, b] : remeshed.features.edges)
        length += (remeshed.surface.vertices.col(a) - remeshed.surface.vertices.col(b)).norm();
    return length;
}

TEST(IsotropicRemesh, KeepsLinesCornersAndFlatFaces) {
    const SurfaceMesh body = box_surface({{0, 0, 0}, {1, 2, 3}});
    const FeatureLines lines = feature_lines(body, 0.3, whatever);
    const auto remeshed = isotropic_remesh(body, lines, 0.3, 5);
    ASSERT_TRUE(remeshed);
    const SurfaceReport report = check_surface(remeshed->surface);
    EXPECT_TRUE(report.meshable() && report.outward);
    EXPECT_NEAR(report.volume, 6.0, 1e-11);
    EXPECT_NEAR(report.area, 22.0, 1e-11);
    EXPECT_NEAR(length_of(*remeshed), 4.0 * (1.0 + 2.0 + 3.0), 1e-12);
    EXPECT_GT(remeshed->features.edges.size(), lines.edges.size()) << "the lines are divided";
    ASSERT_EQ(remeshed->features.corners.size(), 8u);
    for (const int v : remeshed->features.corners) {
        const Eigen::Vector3d x = remeshed->surface.vertices.col(v);
        EXPECT_EQ((body.vertices.colwise() - x).colwise().norm().minCoeff(), 0.0);
    }
    double sum = 0.0;
    for (const auto& t : remeshed->surface.triangles.colwise())
        for (int i = 0; i < 3; ++i)
            sum += (remeshed->surface.vertices.col(t[i]) - remeshed->surface.vertices.col(t[(i + 1) % 3])).norm();
    EXPECT_NEAR(sum / static_cast<double>(3 * remeshed->surface.triangles.cols()), 0.3, 0.1);
}

/// Edges of a body whose lines are not named are cut off by triangles.
TEST(IsotropicRemesh, WithoutLinesRoundsEdgesOff) {
    const SurfaceMesh body = box_surface({{0, 0, 0}, {1, 1, 1}});
    const auto remeshed = isotropic_remesh(body, {}, 0.3, 5);
    ASSERT_TRUE(remeshed);
    EXPECT_TRUE(remeshed->features.edges.empty());
    EXPECT_LT(enclosed_volume(remeshed->surface), 1.0 - 1e-6);
    const SurfaceDistance distance(body);
    for (const auto& x : remeshed->surface.vertices.colwise()) EXPECT_LT(distance.nearest(x).distance, 1e-9);
}

TEST(IsotropicRemesh, RefusesEdgesOfMoreThanTwoTriangles) {
    const SurfaceMesh joined = weld(
        test::together(box_surface({{0, 0, 0}, {1, 1, 1}}), box_surface({{1, 1, 0}, {2, 2, 1}})));
    ASSERT_EQ(check_surface(joined).crowded_edges, 1);
    EXPECT_FALSE(isotropic_remesh(joined, {}, 0.3, 2));
}

}  // namespace
}  // namespace myo::mesh::surface_features_test
