#include "fibre/brush.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "fibre/pulled.hpp"
#include "support/figures.hpp"

namespace myo::fibre {
namespace {

using Eigen::Vector3d;
using test::all_cell_types;

mesh::VolumeMesh cube_mesh(mesh::CellType type, const Eigen::Vector3i& cells) {
    const Box cube{Vector3d::Zero(), Vector3d::Ones()};
    return type == mesh::CellType::hex8 ? mesh::box_hex_mesh(cube, cells) : mesh::tet_box_mesh(cube, cells, type);
}

const Vector3d up = Vector3d::UnitZ();

/// A stroke over the top of a cube of 1 m, through points in its plane.
template <class Curve>
Stroke stroke_over_top(const CellPlaces& places, const Brush& brush, int points, const Curve& curve) {
    Stroke stroke(places, brush);
    for (int k = 0; k < points; ++k) stroke.add(curve(points > 1 ? k / (points - 1.0) : 0.0), up);
    return stroke;
}
Vector3d straight(double s) { return {0.25 + 0.5 * s, 0.5, 1.0}; }
Vector3d circle(double s) {
    return {0.5 + 0.3 * std::cos(2.0 * std::numbers::pi * s), 0.5 + 0.3 * std::sin(2.0 * std::numbers::pi * s), 1.0};
}

CellPaint painted(const mesh::VolumeMesh& mesh, const Stroke& stroke) {
    return stroke.over(blank_paint(mesh), Vector3d::UnitY());
}

/// A straight stroke fills a channel with round ends; on hexahedra and tetrahedra alike.
TEST(Stroke, PaintsAChannel) {
    Brush brush;
    brush.radius_m = 0.15;
    brush.depth_m = 0.3;
    const double expected = 0.3 * (0.5 * 0.3 + std::numbers::pi * 0.15 * 0.15);
    double worst = 0.0;
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh mesh = cube_mesh(
            type, type == mesh::CellType::hex8 ? Eigen::Vector3i(40, 40, 40) : Eigen::Vector3i(20, 20, 20));
        const CellPlaces places = cell_places(mesh, mesh::neighbouring_cells(mesh));
        const CellPaint paint = painted(mesh, stroke_over_top(places, brush, 12, straight));
        const double volume = amount_of(paint, mesh::cell_volumes(mesh)).volume_m3;
        worst = std::max(worst, std::abs(volume / expected - 1.0));
        for (Eigen::Index c = 0; c < paint.count(); ++c)
            if (paint.weights(c) > 0.0) {
                ASSERT_EQ(paint.weights(c), 1.0);
                ASSERT_NEAR(std::abs(paint.directions(0, c)), 1.0, 1e-12);
                ASSERT_GT(places.centre_m(2, c), 0.7 - 1e-12);
            }
    }
    EXPECT_LT(worst, 0.05);
    test::record("worst_volume_error", worst);
}

/// Fibres follow a curved stroke; how many points the hand gave does not matter.
TEST(Stroke, FollowsTheHand) {
    Brush brush;
    brush.radius_m = 0.1;
    brush.depth_m = 0.2;
    const mesh::VolumeMesh mesh = cube_mesh(mesh::CellType::hex8, {24, 24, 8});
    const CellPlaces places = cell_places(mesh, mesh::neighbouring_cells(mesh));
    const CellPaint many = painted(mesh, stroke_over_top(places, brush, 400, circle)),
                    few = painted(mesh, stroke_over_top(places, brush, 60, circle));
    double worst = 0.0, worst_between = 0.0;
    int differing = 0;
    for (Eigen::Index c = 0; c < many.count(); ++c) {
        differing += (many.weights(c) > 0.0) != (few.weights(c) > 0.0);
        if (!(many.weights(c) > 0.0) || !(few.weights(c) > 0.0)) continue;
        const Vector3d radial = places.centre_m.col(c) - Vector3d(0.5, 0.5, 0.0);
        const Vector3d tangent = Vector3d(-radial.y(), radial.x(), 0.0).normalized();
        worst = std::max(worst, 1.0 - std::abs(tangent.dot(many.directions.col(c))));
        worst_between = std::max(worst_between, 1.0 - std::abs(few.directions.col(c).dot(many.directions.col(c))));
    }
    EXPECT_LT(worst, 1.0 - std::cos(0.1));
    EXPECT_LT(worst_between, 1.0 - std::cos(0.1));
    EXPECT_LT(differing, 0.02 * amount_of(many, mesh::cell_volumes(mesh)).cells);
}

TEST(Stroke, MirrorsFallsOffAndErases) {
    const mesh::VolumeMesh mesh = cube_mesh(mesh::CellType::hex8, {20, 20, 5});
    const CellPlaces places = cell_places(mesh, mesh::neighbouring_cells(mesh));
    Brush brush;
    brush.radius_m = 0.2;
    brush.depth_m = std::numeric_limits<double>::infinity();
    brush.falloff = 1.0;
    brush.mirror = MirrorPlane{{0.5, 0.5, 0.5}, Vector3d::UnitY()};
    const auto slanted = [](double s) { return Vector3d(0.2 + 0.6 * s, 0.1 + 0.2 * s, 1.0); };
    const CellPaint paint = painted(mesh, stroke_over_top(places, brush, 30, slanted));
    double least = 1.0;
    const auto at = [&](const Vector3d& x) {
        Eigen::Index c = 0;
        (places.centre_m.colwise() - x).colwise().squaredNorm().minCoeff(&c);
        return c;
    };
    for (Eigen::Index c = 0; c < paint.count(); ++c) {
        const Vector3d x = places.centre_m.col(c);
        const Eigen::Index m = at({x.x(), 1.0 - x.y(), x.z()});
        ASSERT_NEAR(paint.weights(c), paint.weights(m), 1e-12);
        const Vector3d d = paint.directions.col(c), mirrored(d.x(), -d.y(), d.z());
        ASSERT_NEAR(paint.weights(c), paint.weights(at({x.x(), x.y(), 0.1})), 1e-12);  // through the body
        if (!(paint.weights(c) > 0.0)) continue;
        ASSERT_NEAR(std::abs(mirrored.dot(paint.directions.col(m))), 1.0, 1e-9);
        least = std::min(least, paint.weights(c));
    }
    EXPECT_LT(least, 0.2);
    EXPECT_GT(paint.weights.maxCoeff(), 0.9);

    brush.erase = true;
    brush.falloff = 0.0;
    const CellPaint erased = stroke_over_top(places, brush, 30, slanted).over(paint, up);
    EXPECT_EQ(amount_of(erased, mesh::cell_volumes(mesh)).cells, 0);
    EXPECT_EQ(erased.directions.norm(), 0.0);
}

/// A single touch turns no fibres; without paint it takes the direction that it is given, and an axis is always taken.
TEST(Stroke, ATouchHasNoDirectionOfItsOwn) {
    const mesh::VolumeMesh mesh = cube_mesh(mesh::CellType::hex8, {10, 10, 4});
    const CellPlaces places = cell_places(mesh, mesh::neighbouring_cells(mesh));
    Brush brush;
    brush.radius_m = 0.2;
    const auto middle = [](double) { return Vector3d(0.5, 0.5, 1.0); };
    CellPaint before = blank_paint(mesh);
    before.weights.setConstant(0.5);
    before.directions.colwise() = Vector3d::UnitX();
    brush.depth_m = 2.0;
    const CellPaint touched = stroke_over_top(places, brush, 1, middle).over(before, Vector3d::UnitY()),
                    fresh = painted(mesh, stroke_over_top(places, brush, 1, middle));
    brush.axis = up;
    const CellPaint along_axis = stroke_over_top(places, brush, 1, middle).over(before, Vector3d::UnitY());
    int cells = 0;
    for (Eigen::Index c = 0; c < fresh.count(); ++c) {
        if (!(fresh.weights(c) > 0.0)) continue;
        ++cells;
        EXPECT_EQ(touched.weights(c), 1.0);
        EXPECT_EQ(touched.directions.col(c), before.directions.col(c));
        EXPECT_NEAR(std::abs(fresh.directions(1, c)), 1.0, 1e-12);
        EXPECT_NEAR(std::abs(along_axis.directions(2, c)), 1.0, 1e-12);
    }
    EXPECT_GT(cells, 10);
}

}  // namespace
}  // namespace myo::fibre
