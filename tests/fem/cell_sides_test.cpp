#include "fem/cell_sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/meshes.hpp"

// Surroundings of cells in one, two and more layers, free and next to a clamp.

namespace myo::fem::cell_sides_test {
namespace {

using Eigen::Vector3d;

mesh::VolumeMesh grid(ElementKind kind, const Eigen::Vector3i& cells) {
    return test::box_mesh(kind, {Vector3d::Zero(), cells.cast<double>()}, cells);
}

/// Nodes with this coordinate along an axis.
std::vector<bool> nodes_at(const mesh::VolumeMesh& mesh, int axis, double coordinate) {
    std::vector<bool> at;
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) at.push_back(mesh.nodes(axis, i) == coordinate);
    return at;
}

/// Sides along an axis of the cells of a column of hexahedra, from below.
std::vector<CellSides> of_column(int layers, bool held_below, bool held_above, int axis) {
    const mesh::VolumeMesh mesh = grid(ElementKind::hex8, {1, 1, layers});
    std::vector<bool> clamped(static_cast<std::size_t>(mesh.node_count()));
    for (std::size_t i = 0; i < clamped.size(); ++i) {
        const double z = mesh.nodes(2, static_cast<Eigen::Index>(i));
        clamped[i] = (held_below && z == 0.0) || (held_above && z == layers);
    }
    const CellSurroundings around = cell_surroundings(mesh, clamped);
    std::vector<CellSides> sides(around.size());
    for (std::size_t c = 0; c < around.size(); ++c) {
        const double z = mesh.nodes(Eigen::all, mesh.cells.col(static_cast<Eigen::Index>(c))).row(2).minCoeff();
        sides[static_cast<std::size_t>(std::lround(z))] = around[c][static_cast<std::size_t>(axis)];
    }
    return sides;
}

TEST(CellSides, OfAColumnOfHexahedra) {
    using enum CellSides;
    const std::vector<CellSides> none{free}, ends{free, inner, inner, free};
    EXPECT_EQ(of_column(1, false, false, 2), none);
    EXPECT_EQ(of_column(4, false, false, 2), ends);
    EXPECT_EQ(of_column(4, true, false, 2), (std::vector{clamped, inner, inner, free}));
    EXPECT_EQ(of_column(4, false, true, 2), (std::vector{free, inner, inner, clamped}));
    EXPECT_EQ(of_column(2, true, true, 2), (std::vector{clamped, clamped}));
    EXPECT_EQ(of_column(1, true, true, 2), (std::vector{clamped}));
    // Across the column both sides are open, also next to the clamp.
    for (const int axis : {0, 1}) EXPECT_EQ(of_column(3, true, false, axis), (std::vector{free, free, free}));
}

/// Next to a clamp one open side is not enough to be free: the clamp holds the cell's other dimensions.
TEST(CellSides, OfABlockOfHexahedraNextToItsClamp) {
    const mesh::VolumeMesh mesh = grid(ElementKind::hex8, {2, 2, 2});
    const CellSurroundings around = cell_surroundings(mesh, nodes_at(mesh, 2, 0.0));
    for (std::size_t c = 0; c < around.size(); ++c) {
        const bool low = mesh.nodes(Eigen::all, mesh.cells.col(static_cast<Eigen::Index>(c))).row(2).minCoeff() == 0.0;
        EXPECT_EQ(around[c][0], low ? CellSides::inner : CellSides::free);
        EXPECT_EQ(around[c][1], low ? CellSides::inner : CellSides::free);
        EXPECT_EQ(around[c][2], low ? CellSides::clamped : CellSides::free);
    }
    // A part of a face is no clamped face.
    std::vector<bool> few = nodes_at(mesh, 2, 0.0);
    for (std::size_t i = 0; i < few.size(); ++i) few[i] = few[i] && mesh.nodes(0, static_cast<Eigen::Index>(i)) < 1.0;
    for (const std::array<CellSides, 3>& sides : cell_surroundings(mesh, few))
        for (const CellSides side : sides) EXPECT_EQ(side, CellSides::free);
}

/// Number of cells of tetrahedra with these sides, all of whose entries have to be equal.
long count_of(const CellSurroundings& around, CellSides wanted) {
    return std::count_if(around.begin(), around.end(), [&](const std::array<CellSides, 3>& sides) {
        EXPECT_TRUE(sides[0] == sides[1] && sides[1] == sides[2]);
        return sides[0] == wanted;
    });
}

TEST(CellSides, OfTetrahedraInLayers) {
    for (const ElementKind kind : {ElementKind::tet4, ElementKind::tet10}) {
        // In a single layer, clamped at a side or not, every cell reaches across it.
        const mesh::VolumeMesh plate = grid(kind, {4, 4, 1});
        EXPECT_EQ(count_of(cell_surroundings(plate, nodes_at(plate, 0, -1.0)), CellSides::free), plate.cell_count());
        EXPECT_EQ(count_of(cell_surroundings(plate, nodes_at(plate, 0, 0.0)), CellSides::free), plate.cell_count());
        // Two layers: nodes in the middle see both sides.
        const mesh::VolumeMesh two = grid(kind, {4, 4, 2});
        const CellSurroundings of_two = cell_surroundings(two, nodes_at(two, 0, -1.0));
        for (std::size_t c = 0; c < of_two.size(); ++c)
            for (int a = 0; a < 4; ++a) {
                const Vector3d X = two.nodes.col(two.cells(a, static_cast<Eigen::Index>(c)));
                const bool inside = X.x() > 0.0 && X.x() < 4.0 && X.y() > 0.0 && X.y() < 4.0 && X.z() == 1.0;
                if (inside) {
                    EXPECT_EQ(of_two[c][0], CellSides::free);
                }
            }
        // A thick block has no free cells; those with a clamped corner are told apart.
        const mesh::VolumeMesh block = grid(kind, {4, 4, 4});
        EXPECT_EQ(count_of(cell_surroundings(block, nodes_at(block, 0, -1.0)), CellSides::inner), block.cell_count());
        const std::vector<bool> clamped = nodes_at(block, 0, 0.0);
        const CellSurroundings held = cell_surroundings(block, clamped);
        for (std::size_t c = 0; c < held.size(); ++c) {
            bool corner = false;
            for (int a = 0; a < 4; ++a)
                corner = corner || clamped[static_cast<std::size_t>(block.cells(a, static_cast<Eigen::Index>(c)))];
            EXPECT_EQ(held[c][0], corner ? CellSides::clamped : CellSides::inner);
        }
    }
}

}  // namespace
}  // namespace myo::fem::cell_sides_test
