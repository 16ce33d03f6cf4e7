#include "fibre/fibres_along_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "fibre/pulled.hpp"
#include "support/figures.hpp"

namespace myo::fibre {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using test::all_cell_types;
using test::mesh_of;

Polyline through(std::initializer_list<Vector3d> points) {
    Polyline line{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(points.size()))};
    Eigen::Index i = 0;
    for (const Vector3d& x : points) line.points_m.col(i++) = x;
    return line;
}

std::set<int> cells_of(const FibreGroup& group) {
    std::set<int> cells;
    for (const FibrePoint& point : group.points) cells.insert(point.cell);
    return cells;
}

/// F m = m at rest, so the shapes give the direction back.
Vector3d direction_at(const mesh::VolumeMesh& mesh, const FibrePoint& point) {
    Vector3d m = Vector3d::Zero();
    for (int n = 0; n < point.shape.size(); ++n) m += point.shape(n) * mesh.nodes.col(mesh.cells(n, point.cell));
    return m;
}

/// Slanting through the cells, from tubes that are many cells wide to such as are lost in one.
TEST(FibresAlongLine, HaveTheVolumeOfTheCylinder) {
    double worst = 0.0;
    const Polyline line = through({{0.15, 0.3, 0.2}, {0.85, 0.5, 0.4}});
    for (const mesh::CellType type : all_cell_types)
        for (const double radius : {0.15, 0.05, 0.015})
            for (const Eigen::Vector3i& cells :
                 {Eigen::Vector3i(2, 2, 1), Eigen::Vector3i(5, 4, 3), Eigen::Vector3i(9, 7, 5)}) {
                const mesh::VolumeMesh mesh = mesh_of(type, cells);
                const FibreGroup group = fibres_along_line(mesh, line, radius, 1.0, "tube");
                const double error = std::abs(group.volume() / (pi * radius * radius * line.length_m()) - 1.0);
                EXPECT_LT(error, 0.005) << to_string(type) << " " << radius << " " << cells.transpose();
                worst = std::max(worst, error);
                const Vector3d tangent = Vector3d(0.7, 0.2, 0.2).normalized();
                for (const FibrePoint& point : group.points)
                    ASSERT_LT(direction_at(mesh, point).cross(tangent).norm(), 1e-9);
            }
    test::record("worst_volume_error", worst);
}

/// Moments of the fibre field under x = X + (z - z0) X e_x: a fibre along x is stretched by 1 + z - z0.
TEST(FibresAlongLine, ThinTubeKeepsItsLeverArm) {
    for (const Eigen::Vector3i& cells : {Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(4, 3, 3)}) {
        const mesh::VolumeMesh mesh = mesh::box_hex_mesh(test::unit_box(), cells);
        const FibreGroup group = fibres_along_line(mesh, through({{0.2, 0.35, 0.13}, {0.8, 0.35, 0.13}}), 0.1, 1.0,
                                                   "tube");
        double first = 0.0, second = 0.0;
        for (const FibrePoint& point : group.points) {
            double stretch = 0.0;
            for (int n = 0; n < 8; ++n) {
                const Vector3d X = mesh.nodes.col(mesh.cells(n, point.cell));
                stretch += point.shape(n) * (X(0) + X(2) * X(0));
            }
            first += point.volume * (stretch - 1.0);
            second += point.volume * (stretch - 1.13) * (stretch - 1.13);
        }
        EXPECT_NEAR(first / group.volume(), 0.13, 2e-3);
        // Within the sixteenths of a cell's section that make one point, fibres are taken at one height.
        EXPECT_NEAR(second / group.volume(), 0.1 * 0.1 / 4.0, cells(0) == 1 ? 1.5e-3 : 2e-4);
    }
}

/// A tube with a corner: the two cylinders less what each cuts from the other, and a slice of a ball outside.
TEST(FibresAlongLine, CornersAreRoundAndCountOnce) {
    const double radius = 0.1, angle = pi / 2.0;
    const Polyline line = through({{0.1, 0.4, 0.2}, {0.6, 0.4, 0.2}, {0.6, 0.4, 0.5}});
    const double closed_form = pi * radius * radius * 0.8 +
                               2.0 / 3.0 * std::pow(radius, 3) * (angle - 2.0 * std::tan(angle / 2.0));
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh mesh = mesh_of(type, {6, 5, 4});
        const FibreGroup group = fibres_along_line(mesh, line, radius, 1.0, "bent");
        EXPECT_NEAR(group.volume() / closed_form, 1.0, 0.01) << to_string(type);
    }
    EXPECT_NEAR(line.length_m(), 0.8, 1e-15);
    EXPECT_LT((beside_line(line, {0.65, 0.4, 0.15}).tangent - Vector3d(1, 0, 1).normalized()).norm(), 1e-15);
    EXPECT_TRUE(
        fibres_along_line(mesh_of(mesh::CellType::hex8, {2, 2, 2}), through({{2, 0, 0}, {2, 1, 0}}), 0.1, 1.0, "out")
            .points.empty());
}

/// A tube wider than the body is a slab between its flat ends, and so a box.
TEST(FibresAlongLine, PullLikeTheBoxOfTheSamePart) {
    const Polyline line = through({{0.17, 0.4, 0.3}, {0.83, 0.4, 0.3}});
    const Box slab{{0.17, -1, -1}, {0.83, 2, 2}};
    for (const mesh::CellType type : all_cell_types)
        for (const int n : {3, 6, 9}) {
            const mesh::VolumeMesh mesh = mesh_of(type, {n, n, n});
            const FibreGroup tube = fibres_along_line(mesh, line, 1.5, 2.0, "tube"),
                             box = fibres_in_box(mesh, slab, Vector3d::UnitX(), 2.0, "box");
            const auto work = [&](const FibreGroup& group) {
                return test::work(mesh, test::fibre_forces(mesh, group, test::bent(mesh), 0.8));
            };
            // Hexahedra are clipped exactly by a box, tetrahedra have its share spread over them.
            EXPECT_LT(test::relative_difference(work(tube), work(box)),
                      type == mesh::CellType::hex8 ? 1e-3 : 0.3 / (n * n))
                << to_string(type) << " " << n;
        }
    const mesh::VolumeMesh mesh = test::distorted_mesh(mesh::CellType::hex8, {3, 2, 2}, 0.1);
    const FibreGroup whole = fibres_along_line(mesh, through({{-3, 0, 0}, {4, 0, 0}}), 5.0, 2.0, "whole");
    const FibreGroup box = fibres_in_box(mesh, {{-1, -1, -1}, {2, 2, 2}}, Vector3d::UnitX(), 2.0, "box");
    EXPECT_LT(test::relative_difference(test::fibre_forces(mesh, whole, test::bent(mesh), 0.8),
                                        test::fibre_forces(mesh, box, test::bent(mesh), 0.8)),
              1e-12);
}

TEST(FibresInColumn, AreWholeCellsOfOneColumn) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(test::unit_box(), {5, 4, 6});
    const FibreGroup column = fibres_in_column(mesh, {0.5, 0.3, 0.2}, Vector3d::UnitZ(), 2.0, "column");
    EXPECT_NEAR(column.volume(), 0.2 * 0.2 * 0.6, 1e-12);
    EXPECT_EQ(cells_of(column).size(), 6u);
    const FibreGroup box = fibres_in_box(mesh, {{0.4, 0.2, 0.0}, {0.6, 0.4, 0.6}}, Vector3d::UnitZ(), 2.0, "box");
    EXPECT_LT(test::relative_difference(test::fibre_forces(mesh, column, test::bent(mesh), 1.2),
                                        test::fibre_forces(mesh, box, test::bent(mesh), 1.2)),
              1e-12);
    // On a face, and on an edge of the grid, it is one column still.
    for (const Vector3d& between : {Vector3d(0.4, 0.3, 0.0), Vector3d(0.4, 0.4, 0.1), Vector3d(0.0, 0.0, 0.0)})
        EXPECT_LE(cells_of(fibres_in_column(mesh, between, Vector3d::UnitZ(), 2.0, "between")).size(), 6u)
            << between.transpose();
    EXPECT_EQ(cells_of(fibres_in_column(mesh, {0.4, 0.4, 0.1}, Vector3d::UnitZ(), 2.0, "between")).size(), 6u);
    EXPECT_TRUE(fibres_in_column(mesh, {1.5, 0.3, 0.0}, Vector3d::UnitZ(), 2.0, "out").points.empty());
    for (const mesh::CellType type : {mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh tets = mesh::tet_box_mesh(test::unit_box(), {5, 4, 6}, type);
        const FibreGroup pierced = fibres_in_column(tets, {0.5, 0.31, 0.2}, Vector3d::UnitZ(), 2.0, "column");
        EXPECT_GE(cells_of(pierced).size(), 6u);
        EXPECT_LT(pierced.volume(), 0.2 * 0.2 * 0.6 + 1e-12);  // a cube's tetrahedra, not all of them
    }
}

}  // namespace
}  // namespace myo::fibre
