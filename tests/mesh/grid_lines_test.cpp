#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/box_mesh.hpp"
#include "mesh/plane_cut.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"

// Grids of boxes: planes that must be met, edges that vary, whole cubes, numbering of nodes and cells, what is a box.

namespace myo::mesh::grid_lines_test {
namespace {

using testing::HasSubstr;
using Lines = std::vector<double>;

const Box unit{{0, 0, 0}, {1, 1, 1}};

TEST(GridLines, PlanesMayComeInAnyOrderAndTwice) {
    // The last two and the first lie on or beyond the box, 0.5 comes again within a millionth.
    const GridLines grid = grid_lines(unit, 1.0, {{{-3.0, 0.5, 0.5 + 1e-8, 0.2, 0.5, 1.0 - 1e-8, 7.0}, {}, {}}});
    EXPECT_EQ(grid.axis[0], (Lines{0.0, 0.2, 0.5, 1.0}));
    EXPECT_EQ(grid.axis[1], (Lines{0.0, 1.0}));
    EXPECT_EQ(grid.cells(), Eigen::Vector3i(3, 1, 1));
    // Two planes just far enough apart are two.
    EXPECT_EQ(grid_lines(unit, 1.0, {{{}, {0.5, 0.5 + 2e-6}, {}}}).axis[1].size(), 4u);
}

/// The edge length is asked for at the middle of every interval between planes.
TEST(GridLines, EdgesMayVaryBetweenPlanes) {
    std::vector<std::pair<int, double>> asked;
    const auto edge = [&](int axis, double at) {
        asked.emplace_back(axis, at);
        return axis == 0 && at < 0.25 ? 0.05 : axis == 0 ? 0.25 : 0.5;
    };
    const GridLines grid = grid_lines(unit, edge, {{{0.25}, {}, {}}});
    EXPECT_EQ(grid.cells(), Eigen::Vector3i(5 + 3, 2, 2));
    for (int k = 0; k <= 5; ++k) EXPECT_NEAR(grid.axis[0][static_cast<std::size_t>(k)], 0.05 * k, 1e-15);
    EXPECT_EQ(grid.axis[0][5], 0.25) << "a plane is met to the last bit";
    EXPECT_NEAR(grid.axis[0][6], 0.5, 1e-15);
    EXPECT_EQ(asked, (std::vector<std::pair<int, double>>{{0, 0.125}, {0, 0.625}, {1, 0.5}, {2, 0.5}}));
}

TEST(GridLines, CountsAreRoundedAndLimited) {
    EXPECT_EQ(box_cells({{0, 0, 0}, {1, 2, 3}}, 0.401), Eigen::Vector3i(2, 5, 7));
    EXPECT_EQ(box_cells({{0, 0, 0}, {1, 2, 3}}, 0.399), Eigen::Vector3i(3, 5, 8));
    EXPECT_EQ(box_cells(unit, 1e-12), Eigen::Vector3i::Constant(1000000000));
    const Result<GridLines> many = limited_grid_lines({{0, 0, 0}, {0.1, 0.03, 0.02}}, 1e-3, {}, 59999.0);
    ASSERT_FALSE(many);
    EXPECT_EQ(many.error().what,
              "an edge of 1 mm needs a grid of 6e+04 cells, over the limit of 6e+04: choose a longer edge");
    EXPECT_TRUE(limited_grid_lines({{0, 0, 0}, {0.1, 0.03, 0.02}}, 1e-3, {}, 60000.0));
}

TEST(WholeCubes, FillTheBoxFromEitherSide) {
    const Box box{{0.0, 0.0, -0.01}, {0.3, 0.35, 0.19}};
    const Result<GridLines> low = whole_cube_lines(box, 0.1, {false, false, false}),
                            high = whole_cube_lines(box, 0.1, {false, true, true});
    ASSERT_TRUE(low && high);
    EXPECT_EQ(low->cells(), Eigen::Vector3i(3, 3, 2)) << "0.3 / 0.1 is a little less than 3";
    EXPECT_EQ(high->cells(), low->cells());
    EXPECT_EQ(low->axis[1].front(), 0.0);
    EXPECT_NEAR(low->axis[1].back(), 0.3, 1e-15);
    EXPECT_NEAR(high->axis[1].front(), 0.05, 1e-15);
    EXPECT_EQ(high->axis[1].back(), 0.35);
    EXPECT_EQ(high->axis[2].back(), 0.19);
    const Eigen::VectorXd volumes = cell_volumes(hex_mesh(*high));
    EXPECT_LT((volumes.array() - 1e-3).abs().maxCoeff(), 1e-16) << "cubes, all of them";
    EXPECT_EQ(whole_cube_lines({{0, 0, 0}, {0.3 * (1.0 - 1e-8), 1, 1}}, 0.1, {})->cells().x(), 2);
}

TEST(WholeCubes, SayWhyThereAreNone) {
    const Box box{{0, 0, 0}, {0.1, 0.035, 0.0199}};
    EXPECT_EQ(whole_cube_lines(box, 0.02, {}).error().what,
              "no whole cube of 20 mm fits into the body: choose a shorter edge");
    EXPECT_TRUE(whole_cube_lines(box, 0.0199, {}));
    EXPECT_TRUE(whole_cube_lines(box, 1e-3, {}, 100.0 * 35.0 * 19.0));
    EXPECT_THAT(whole_cube_lines(box, 1e-3, {}, 100.0 * 35.0 * 19.0 - 1.0).error().what,
                HasSubstr("an edge of 1 mm needs a grid of"));
    EXPECT_FALSE(whole_cube_lines(box, 1e-12, {})) << "before any memory is taken";
}

/// Nodes and cells run along x first, then y, then z.
TEST(HexMesh, NumbersNodesAndCellsAlongTheAxes) {
    const GridLines grid{{Lines{0.0, 0.1, 0.4}, Lines{1.0, 1.5}, Lines{-1.0, 0.0, 2.0, 2.5}}};
    const VolumeMesh mesh = hex_mesh(grid);
    ASSERT_EQ(mesh.node_count(), 3 * 2 * 4);
    ASSERT_EQ(mesh.cell_count(), 2 * 1 * 3);
    const auto node = [](int i, int j, int k) { return (2 * k + j) * 3 + i; };
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 3; ++i) {
                const auto at = [&](std::size_t axis, int n) { return grid.axis[axis][static_cast<std::size_t>(n)]; };
                EXPECT_EQ(mesh.nodes.col(node(i, j, k)), Eigen::Vector3d(at(0, i), at(1, j), at(2, k)));
            }
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 2; ++i) {
            EXPECT_EQ(mesh.cells(0, 2 * k + i), node(i, 0, k));
            EXPECT_EQ(mesh.cells(6, 2 * k + i), node(i + 1, 1, k + 1)) << "the corner across";
        }
}

/// Mid-side nodes stand behind the corners, in the order of their edges; regions stay.
TEST(ToTet10, NumbersMidSidesByTheirEdges) {
    VolumeMesh linear = tet_box_mesh(test::unequal_box(), {2, 1, 1});
    for (Eigen::Index c = 0; c < linear.cell_count(); ++c) linear.regions.push_back(static_cast<int>(c % 3));
    const VolumeMesh quadratic = to_tet10(linear);
    EXPECT_EQ(quadratic.regions, linear.regions);
    EXPECT_EQ(quadratic.cells.topRows(4), linear.cells);
    EXPECT_EQ(quadratic.nodes.leftCols(linear.node_count()), linear.nodes);
    constexpr std::array<std::array<int, 2>, 6> ends{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
    std::vector<std::pair<int, int>> edges(static_cast<std::size_t>(quadratic.node_count() - linear.node_count()));
    for (Eigen::Index c = 0; c < linear.cell_count(); ++c)
        for (Eigen::Index e = 0; e < 6; ++e) {
            const auto [a, b] = ends[static_cast<std::size_t>(e)];
            const int low = std::min(linear.cells(a, c), linear.cells(b, c)),
                      high = std::max(linear.cells(a, c), linear.cells(b, c)), middle = quadratic.cells(4 + e, c);
            EXPECT_EQ(quadratic.nodes.col(middle), 0.5 * (linear.nodes.col(low) + linear.nodes.col(high)));
            edges[static_cast<std::size_t>(middle - linear.node_count())] = {low, high};
        }
    EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end()) << "each edge has one node";
}

TEST(IsBox, AllowsForItsToleranceOnly) {
    const SurfaceMesh box = box_surface({{0, 0, 0}, {1, 2, 4}});
    for (const double inward : {3e-6, 5e-6}) {
        SurfaceMesh dented = box;
        dented.vertices.col(6).array() -= inward;
        EXPECT_EQ(is_box(dented).has_value(), inward < 4e-6) << "a millionth of the longest side is allowed";
        EXPECT_TRUE(is_box(dented, 1e-5));
    }
}

TEST(IsBox, DependsOnTheShapeAndNotOnItsTriangles) {
    const SurfaceMesh box = box_surface({{0, 0, 0}, {1, 2, 4}});
    const SurfaceMesh cut = cut_by_plane(cut_by_plane(box, {2, 1.3}, {{-9, -9, -9}, {9, 9, 9}}), {0, 0.4},
                                         {{-9, -9, -9}, {9, 9, 9}});
    ASSERT_GT(cut.vertices.cols(), 16);
    const std::optional<Box> found = is_box(cut);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->highest, Eigen::Vector3d(1, 2, 4));
    EXPECT_FALSE(is_box(test::together(box, flipped(box_surface({{0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}}))))) << "hollow";
    EXPECT_FALSE(is_box(box_surface({{0, 0, 0}, {1, 2, 0}}))) << "flat";
    EXPECT_FALSE(is_box(test::l_shape()));
    EXPECT_FALSE(is_box(test::cylinder(4, 1.0, 1.0))) << "turned about its axis";
    EXPECT_FALSE(is_box(SurfaceMesh{}));
}

}  // namespace
}  // namespace myo::mesh::grid_lines_test
