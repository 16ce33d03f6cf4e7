#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "commands/body_cut.hpp"
#include "commands/region_drawing.hpp"
#include "commands/rest_outline.hpp"
#include "mesh/box_mesh.hpp"
#include "viewport/scene_lines.hpp"

// Lines of the view: grid, boxes, arrows, outlines, and the cut of a body.

namespace myo::ui::drawn_lines {
namespace {

using Eigen::Vector3d;
using viewport::Color;

const Box unit_box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
const Color green(0.1f, 0.8f, 0.2f, 0.5f);

TEST(DrawnLine, IsInterruptedWhereAPointIsMissing) {
    viewport::DrawnLine line;
    line.points.resize(3, 6);
    for (int i = 0; i < 6; ++i) line.points.col(i) << i, 10.0 * i, -i;
    line.points(1, 3) = std::numeric_limits<double>::quiet_NaN();
    line.color = green;
    std::vector<float> segments{7.0f};
    viewport::append_segments(segments, line);
    // Behind what was there: from 0 to 1, 1 to 2 and 4 to 5.
    ASSERT_EQ(segments.size(), 1u + 3u * 10u);
    EXPECT_EQ(segments[0], 7.0f);
    EXPECT_EQ(std::vector<float>(segments.begin() + 21, segments.end()),
              (std::vector<float>{4.0f, 40.0f, -4.0f, 5.0f, 50.0f, -5.0f, 0.1f, 0.8f, 0.2f, 0.5f}));
    line.points.conservativeResize(3, 1);
    segments.clear();
    viewport::append_segments(segments, line);
    EXPECT_TRUE(segments.empty()) << "one point is no line";
}

TEST(Grid, LiesBelowTheBodyOnRoundMultiplesAndFadesAlikeToAllSides) {
    const Box body{{0.013, -0.02, 0.1}, {0.103, 0.01, 0.14}};
    // A fifth of 90 mm is 18 mm; the next round length is 20 mm. The middle, (58, -5) mm, lies nearest to (60, 0) mm.
    constexpr double cell = 0.02, x0 = 0.06, y0 = 0.0, z = 0.1 - 0.25 * 0.04;
    const std::vector<float> segments = viewport::grid_segments(body, green);
    ASSERT_EQ(segments.size() % 10, 0u);
    const auto value = [&](std::size_t i) { return static_cast<double>(segments[i]); };
    double moment_x = 0.0, moment_y = 0.0, strongest = 0.0, weakest = 1.0;
    for (std::size_t s = 0; s < segments.size(); s += 10) {
        for (const std::size_t end : {s, s + 3}) {
            EXPECT_NEAR(std::remainder(value(end), cell), 0.0, 1e-7);
            EXPECT_NEAR(std::remainder(value(end + 1), cell), 0.0, 1e-7);
            EXPECT_NEAR(value(end + 2), z, 1e-7);
            moment_x += value(s + 9) * (value(end) - x0);
            moment_y += value(s + 9) * (value(end + 1) - y0);
        }
        EXPECT_NEAR(std::hypot(value(s + 3) - value(s), value(s + 4) - value(s + 1)), cell, 1e-7) << "one square long";
        strongest = std::max(strongest, value(s + 9));
        weakest = std::min(weakest, value(s + 9));
    }
    EXPECT_NEAR(moment_x, 0.0, 1e-5);
    EXPECT_NEAR(moment_y, 0.0, 1e-5);
    EXPECT_FLOAT_EQ(static_cast<float>(strongest), green[3]);
    EXPECT_EQ(weakest, 0.0);
    EXPECT_TRUE(viewport::grid_segments(Box{}, green).empty()) << "a point has no grid";
}

TEST(Arrow, IsAsLongAsItsForceWithFourBarbsAroundIt) {
    const Vector3d from(0.1, -0.2, 0.3);
    for (const Vector3d& along : {Vector3d(0.0, 0.0, 2.0), Vector3d(-3.0, 4.0, 0.0), Vector3d(1e-3, 1e-3, -1e-3)}) {
        const Eigen::Matrix<double, 3, 10> points = viewport::arrow_points(from, along);
        const Vector3d tip = from + along;
        EXPECT_EQ(points.col(0), from);
        for (const int i : {1, 3, 5, 7}) EXPECT_EQ(points.col(i), tip);
        Vector3d sum = Vector3d::Zero();
        for (const int i : {2, 4, 6, 8}) {
            const Vector3d barb = points.col(i) - (from + 0.75 * along);
            EXPECT_NEAR(barb.dot(along), 0.0, 1e-12 * along.squaredNorm());
            EXPECT_NEAR(barb.norm(), 0.09 * along.norm(), 1e-12 * along.norm());
            sum += barb;
        }
        EXPECT_LT(sum.norm(), 1e-12 * along.norm());
        EXPECT_NEAR((points.col(2) - tip).dot(points.col(6) - tip), std::pow(0.25 * along.norm(), 2),
                    1e-12 * along.squaredNorm())
            << "neighbours stand at right angles";
        EXPECT_TRUE(points.col(9).array().isNaN().all()) << "the next arrow is not joined to it";
    }
}

TEST(BoxLines, AreTheTwelveEdges) {
    const Box box{{1.0, 2.0, 3.0}, {1.5, 4.0, 3.25}};
    const std::vector<viewport::DrawnLine> lines = viewport::box_lines(box, green, 2.5);
    ASSERT_EQ(lines.size(), 12u);
    Vector3d length = Vector3d::Zero();
    std::set<std::tuple<double, double, double>> middles;
    for (const viewport::DrawnLine& line : lines) {
        ASSERT_EQ(line.points.cols(), 2);
        const Vector3d along = line.points.col(1) - line.points.col(0), middle = line.points.rowwise().mean();
        EXPECT_EQ((along.array() != 0.0).count(), 1) << "along one axis";
        for (int k = 0; k < 2; ++k) EXPECT_TRUE(box.contains(line.points.col(k)));
        length += along.cwiseAbs();
        middles.insert({middle.x(), middle.y(), middle.z()});
        EXPECT_EQ(line.color, green);
        EXPECT_EQ(line.width, 2.5);
    }
    EXPECT_EQ(length, 4.0 * box.size());
    EXPECT_EQ(middles.size(), 12u) << "each of them once";
}

/// Lengths of the sides of a closed polygon; all corners are expected on the plane and in the box.
std::vector<double> sides(const commands::ClipPlane& plane) {
    const Eigen::Matrix3Xd points = commands::outline_of(plane, unit_box);
    std::vector<double> lengths;
    for (Eigen::Index i = 0; i + 1 < points.cols(); ++i) {
        EXPECT_NEAR(plane.normal.dot(points.col(i)), plane.position_m, 1e-12);
        EXPECT_TRUE(Box({Vector3d::Constant(-1e-12), Vector3d::Constant(1.0 + 1e-12)}).contains(points.col(i)));
        lengths.push_back((points.col(i + 1) - points.col(i)).norm());
    }
    const bool closed = points.cols() == 0 || points.col(0) == points.col(points.cols() - 1);
    EXPECT_TRUE(closed);
    return lengths;
}

TEST(CutOutline, IsTheTriangleOrHexagonOfASkewPlane) {
    const Vector3d diagonal = Vector3d::Ones().normalized();
    for (const double sum : {0.5, 1.5, 2.5}) {
        const std::vector<double> lengths = sides({true, diagonal, sum / std::sqrt(3.0), false});
        // Through the middle a regular hexagon; near a corner a regular triangle whose legs are half an edge.
        ASSERT_EQ(lengths.size(), sum == 1.5 ? 6u : 3u) << sum;
        for (const double length : lengths) EXPECT_NEAR(length, std::sqrt(0.5), 1e-12) << "not in turn";
    }
    EXPECT_TRUE(sides({true, diagonal, -0.01, false}).empty());
    EXPECT_TRUE(sides({true, diagonal, 1.74, false}).empty()) << "beyond the far corner at the root of three";
    const std::vector<double> rectangle = sides({true, Vector3d(1.0, 1.0, 0.0).normalized(), std::sqrt(0.5), false});
    ASSERT_EQ(rectangle.size(), 4u);
    EXPECT_NEAR(rectangle[0] * rectangle[1], std::sqrt(2.0), 1e-12) << "its area";
}

TEST(ClipPlane, TakesOneSideAndTheOtherOneFlipped) {
    commands::ClipPlane plane{true, Vector3d(0.6, 0.8, 0.0), 0.5, false}, flipped = plane;
    flipped.flip = true;
    for (const double beyond : {-0.2, -1e-12, 1e-12, 0.2}) {
        const Vector3d at = (0.5 + beyond) * plane.normal + Vector3d(0.0, 0.0, 7.0);
        EXPECT_EQ(plane.removes(at), beyond > 0.0) << beyond;
        EXPECT_EQ(flipped.removes(at), beyond < 0.0) << beyond;
    }
}

TEST(RestOutline, HasEachEdgeOnceAndNoneOfTheInside) {
    const auto edges = [](const mesh::VolumeMesh& mesh) {
        commands::MeshedBody body;
        body.mesh = mesh;
        body.boundary = mesh::boundary_faces(mesh);
        const Eigen::Matrix3Xd points = commands::rest_outline(body);
        double longest = 0.0;
        for (Eigen::Index i = 0; i < points.cols(); i += 3) {
            longest = std::max(longest, (points.col(i + 1) - points.col(i)).norm());
            EXPECT_TRUE(points.col(i + 2).array().isNaN().all());
        }
        return std::pair(points.cols() / 3, longest);
    };
    EXPECT_EQ(edges(mesh::box_hex_mesh(unit_box, {1, 1, 1})), std::pair(Eigen::Index{12}, 1.0));
    // Four edges of the face between the two are drawn, as they lie on the surface; none crosses the body.
    EXPECT_EQ(edges(mesh::box_hex_mesh({{0, 0, 0}, {2, 1, 1}}, {2, 1, 1})).first, 20);
    EXPECT_EQ(edges(mesh::box_hex_mesh(unit_box, {2, 2, 2})).first, 48)
        << "2 on each of 12 edges, 4 on each of 6 faces";
    for (const mesh::CellType type : {mesh::CellType::tet4, mesh::CellType::tet10}) {
        const auto [count, longest] = edges(mesh::tet_box_mesh(unit_box, {1, 1, 1}, type));
        EXPECT_EQ(count, 18) << "edges, and a diagonal of each side";
        EXPECT_NEAR(longest, std::sqrt(2.0), 1e-12) << "from corner to corner, not to the middles of sides";
    }
}

TEST(Region, TintsFacesThatLieInItAndLeavesTheOthers) {
    viewport::DrawnScene drawn;
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh({{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
    drawn.body = std::make_shared<viewport::DrawnBody>(viewport::DrawnBody{mesh::boundary_faces(mesh), {}});
    drawn.positions = mesh.nodes;
    drawn.tints = Eigen::Matrix4Xf::Constant(4, drawn.body->faces.count(), 0.25f);
    // The first cell has five faces on the boundary; the box cuts the second one.
    commands::add_region(drawn, {{0, 0, 0}, {1.5, 1, 1}}, green);
    EXPECT_EQ(drawn.lines.size(), 12u);
    for (Eigen::Index f = 0; f < drawn.tints.cols(); ++f) {
        const bool inside = drawn.body->faces.cell(f) == 0;
        EXPECT_EQ(drawn.tints(1, f), inside ? green[1] : 0.25f) << f;
        EXPECT_EQ(drawn.tints(3, f) == 0.25f, !inside);
    }
    // Where the body moves, the place in the view counts.
    drawn.tints.resize(4, 0);
    drawn.positions.row(0).array() += 1.0;
    commands::add_region(drawn, {{0, 0, 0}, {1.5, 1, 1}}, green);
    EXPECT_EQ((drawn.tints.row(3).array() > 0.0f).count(), 1) << "the end, at x = 1 now";
    drawn.body.reset();
    commands::add_region(drawn, unit_box, green);
    EXPECT_EQ(drawn.lines.size(), 36u) << "the box is drawn before there is a mesh";
}

}  // namespace
}  // namespace myo::ui::drawn_lines
