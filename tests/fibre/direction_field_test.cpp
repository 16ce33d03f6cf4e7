#include "fibre/direction_field.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

#include "fibre/cell_parts.hpp"
#include "fibre/pulled.hpp"

namespace myo::fibre {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::all_cell_types;
using test::mesh_of;

Vector3d centre(const mesh::VolumeMesh& mesh, int cell) { return place_of(mesh, cell, whole_cell(mesh.type)).centre_m; }

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

TEST(DirectionField, ConstantAlongALineAndTowardsTheLongestAxis) {
    const mesh::VolumeMesh mesh = test::distorted_mesh(mesh::CellType::hex8, {6, 4, 3}, 0.05);
    EXPECT_EQ(constant_directions(mesh, Vector3d::UnitY()).col(7), Vector3d::UnitY());
    const Polyline line{(Matrix3Xd(3, 3) << 0, 0.5, 0.5, 0.1, 0.1, 0.7, 0.3, 0.3, 0.3).finished()};
    const Matrix3Xd along = directions_along(mesh, line);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c)
        EXPECT_LT((along.col(c) - beside_line(line, centre(mesh, c)).tangent).norm(), 1e-15);
    EXPECT_EQ(Vector3d(beside_line(line, {0.2, 0.15, 0.2}).tangent), Vector3d::UnitX());
    EXPECT_EQ(Vector3d(beside_line(line, {0.55, 0.6, 0.2}).tangent), Vector3d::UnitY());
    for (const mesh::CellType type : all_cell_types) {
        const Matrix3Xd longest = directions_along_longest_axis(mesh_of(type, {3, 3, 3}));
        for (const Vector3d d : longest.colwise())
            EXPECT_LT(angle_between(d, Vector3d::UnitX()), 1e-3) << to_string(type);
    }
    // Only the painted part counts: a slice is longest across the body.
    const mesh::VolumeMesh grid = mesh_of(mesh::CellType::hex8, {10, 4, 4});
    Eigen::VectorXd slice = Eigen::VectorXd::Zero(grid.cell_count());
    for (int c = 0; c < static_cast<int>(grid.cell_count()); ++c) slice(c) = centre(grid, c)(0) < 0.1 ? 1.0 : 0.0;
    EXPECT_LT(angle_between(directions_along_longest_axis(grid, slice).col(0), Vector3d::UnitY()), 1e-12);
}

/// Given at both ends only, the dyad is linear between them, and the line is its main axis: a closed form for any pair
/// of lines.
TEST(DirectionField, SmoothDirectionsAreHarmonic) {
    const Vector3d left = Vector3d::UnitX(), right = -Vector3d(std::cos(0.9), std::sin(0.9), 0.0);
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh mesh = mesh_of(type, {8, 3, 2});
        std::vector<int> cells;
        std::vector<Vector3d> given;
        for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
            const double x = centre(mesh, c)(0);
            if (x > 0.125 && x < 0.875) continue;
            cells.push_back(c);
            given.push_back(x < 0.5 ? left : right);
        }
        const Matrix3Xd field = smooth_directions(
            mesh, cells, Eigen::Map<const Matrix3Xd>(given.front().data(), 3, static_cast<Eigen::Index>(given.size())));
        int between = 0;
        for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
            EXPECT_NEAR(field.col(c).norm(), 1.0, 1e-12);
            const double s = (centre(mesh, c)(0) - 0.125) / 0.75;  // 0 and 1 at the inner faces of the end layers
            if (s < 0.0 || s > 1.0) continue;
            const Matrix3d dyad = (1.0 - s) * left * left.transpose() + s * right * right.transpose();
            EXPECT_LT(angle_between(field.col(c), mean_line(dyad)), 1e-9) << to_string(type);
            ++between;
        }
        EXPECT_GT(between, 20);
        EXPECT_EQ(Vector3d(field.col(cells.front())), left);
    }
}

}  // namespace
}  // namespace myo::fibre
