#include "mesh/voxel_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "mesh/cell_topology.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "support/shared_data.hpp"

namespace myo::mesh {
namespace {

VoxelOptions voxels_of(double edge) {
    VoxelOptions options;
    options.edge = edge;
    return options;
}

TEST(Voxelize, BoxIsMetExactly) {
    const Box box{{0.01, -0.02, 0.0}, {0.11, 0.01, 0.03}};
    for (const double edge : {0.1, 0.007, 0.0031}) {
        const auto mesh = voxelize(box_surface(box), voxels_of(edge));
        ASSERT_TRUE(mesh);
        EXPECT_EQ(mesh->cell_count(), box_cells(box, edge).prod());
        EXPECT_EQ(bounding_box(mesh->nodes).lowest, box.lowest);
        EXPECT_EQ(bounding_box(mesh->nodes).highest, box.highest);
        EXPECT_NEAR(cell_volumes(*mesh).sum(), 9e-5, 1e-17);
    }
}

TEST(Voxelize, LShapeIsExactOnItsGrid) {
    const auto mesh = voxelize(test::l_shape(), voxels_of(0.0025));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->cell_count(), 3 * 4 * 4 * 4);
    EXPECT_NEAR(cell_volumes(*mesh).sum(), 3e-6, 1e-17);
}

TEST(Voxelize, CylinderVolumeConverges) {
    const SurfaceMesh surface = test::cylinder(64, 0.015, 0.06);
    double previous = 1.0;
    for (const double edge : {0.005, 0.001, 0.0004}) {
        const auto mesh = voxelize(surface, voxels_of(edge));
        ASSERT_TRUE(mesh);
        const double error = std::abs(*mesh_quality(*mesh, &surface).volume_error);
        EXPECT_LT(error, previous);
        previous = error;
    }
    EXPECT_LT(previous, 0.003);
}

TEST(Voxelize, OrientationAndRotationOfTheGridPlanesDoNotMatter) {
    const SurfaceMesh surface = test::cylinder(24, 0.015, 0.06);
    const auto outward = voxelize(surface, voxels_of(0.003)), inward = voxelize(flipped(surface), voxels_of(0.003));
    ASSERT_TRUE(outward && inward);
    EXPECT_EQ(outward->cells, inward->cells);
}

TEST(Voxelize, CavityStaysHollowAndOverlapIsOneBody) {
    const Box outer{{0, 0, 0}, {0.04, 0.04, 0.04}}, inner{{0.01, 0.01, 0.01}, {0.03, 0.03, 0.03}};
    const auto hollow = voxelize(test::together(box_surface(outer), flipped(box_surface(inner))), voxels_of(0.005));
    ASSERT_TRUE(hollow);
    EXPECT_EQ(hollow->cell_count(), 8 * 8 * 8 - 4 * 4 * 4);
    const auto merged = voxelize(test::together(box_surface(outer), box_surface(inner)), voxels_of(0.005));
    ASSERT_TRUE(merged);
    EXPECT_EQ(merged->cell_count(), 8 * 8 * 8);
}

TEST(Voxelize, GridPlanesAreMet) {
    VoxelOptions options = voxels_of(0.01);
    options.planes[0] = {5e-4};
    const auto mesh = voxelize(box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}}), options);
    ASSERT_TRUE(mesh);
    EXPECT_EQ((mesh->nodes.row(0).array() == 5e-4).count(), 16);
}

TEST(Voxelize, BadInputIsAnError) {
    SurfaceMesh open = box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    EXPECT_FALSE(voxelize(open, voxels_of(0.0)));
    EXPECT_FALSE(voxelize(open, voxels_of(1e-5)));
    open.triangles = open.triangles.leftCols(11).eval();
    const auto result = voxelize(open, voxels_of(0.01));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().what.find("not closed"), std::string::npos);
    EXPECT_FALSE(voxelize(SurfaceMesh{}, voxels_of(0.01)));
    // A tube with thin walls and a coarse grid: nothing is half full.
    const SurfaceMesh tube = test::together(box_surface({{0, 0, 0}, {0.1, 0.1, 0.1}}),
                                            flipped(box_surface({{1e-3, 1e-3, 1e-3}, {0.099, 0.099, 0.099}})));
    EXPECT_FALSE(voxelize(tube, voxels_of(0.05)));
}

TEST(Connectivity, NamesWeakJoints) {
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {0.02, 0.02, 0.01}}, {2, 2, 1});
    EXPECT_EQ(connectivity(mesh).components, 1);
    EXPECT_EQ(connectivity(mesh).weak_nodes, 0);
    mesh.cells = mesh.cells(Eigen::all, std::vector<int>{0, 3}).eval();  // diagonal neighbours: one common edge
    EXPECT_EQ(connectivity(mesh).components, 2);
    EXPECT_EQ(connectivity(mesh).weak_edges, 1);
    EXPECT_EQ(connectivity(mesh).weak_nodes, 2);
    EXPECT_FALSE(mesh_quality(mesh).messages.empty());
    EXPECT_EQ(connectivity(tet_box_mesh(test::unequal_box(), {2, 2, 2})).components, 1);
    EXPECT_EQ(connectivity(tet_box_mesh(test::unequal_box(), {2, 2, 2})).weak_nodes, 0);
}

bool holds(const VolumeMesh& mesh, Eigen::Index cell, int node) { return (mesh.cells.col(cell).array() == node).any(); }

/// Whether the cells that hold all these nodes fall apart when only faces that hold them too join cells. For grids,
/// whose cells have a face in common when they have so many corners in common.
bool falls_apart(const VolumeMesh& mesh, const std::vector<int>& nodes) {
    std::vector<Eigen::Index> cells;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        if (std::all_of(nodes.begin(), nodes.end(), [&](int n) { return holds(mesh, c, n); })) cells.push_back(c);
    std::vector<bool> reached(cells.size(), false);
    std::vector<std::size_t> open{0};
    reached[0] = true;
    while (!open.empty()) {
        const std::size_t a = open.back();
        open.pop_back();
        for (std::size_t b = 0; b < cells.size(); ++b) {
            int common = 0;
            for (const int node : mesh.cells.col(cells[a])) common += holds(mesh, cells[b], node) ? 1 : 0;
            if (reached[b] || common < (mesh.type == CellType::hex8 ? 4 : 3)) continue;
            reached[b] = true;
            open.push_back(b);
        }
    }
    return std::find(reached.begin(), reached.end(), false) != reached.end();
}

TEST(Connectivity, AgreesWithASearchOfEveryNodeAndEdgeOfPorousMeshes) {
    std::mt19937 random(3);
    for (VolumeMesh mesh :
         {box_hex_mesh(test::unequal_box(), {5, 5, 5}), tet_box_mesh(test::unequal_box(), {3, 3, 3})}) {
        std::vector<Eigen::Index> kept;
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
            if (random() % 5 < 2) kept.push_back(c);
        mesh.cells = mesh.cells(Eigen::all, kept).eval();
        std::set<int> nodes;
        std::set<std::pair<int, int>> edges;
        for (const auto& cell : mesh.cells.colwise()) {
            nodes.insert(cell.begin(), cell.end());
            const auto add = [&](const auto& table) {
                for (const auto& [a, b] : table) edges.insert(std::minmax<int>(cell[a], cell[b]));
            };
            if (mesh.type == CellType::hex8)
                add(hexahedron_edges);
            else
                add(tetrahedron_edges);
        }
        int weak_nodes = 0, weak_edges = 0;
        for (const int n : nodes) weak_nodes += falls_apart(mesh, {n}) ? 1 : 0;
        for (const auto& [a, b] : edges) weak_edges += falls_apart(mesh, {a, b}) ? 1 : 0;
        const Connectivity held = connectivity(mesh);
        EXPECT_GT(weak_nodes, 10);
        EXPECT_EQ(held.weak_nodes, weak_nodes);
        EXPECT_EQ(held.weak_edges, weak_edges);
        EXPECT_EQ(held.components > 1, falls_apart(mesh, {}));
    }
}

TEST(RealGeometry, VoxelVolumesApproachTheSurface) {
    const std::vector<std::filesystem::path> bodies = test::shared_bodies();
    if (bodies.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& path : bodies) {
        const SurfaceMesh surface = weld(*read_surface(path, 1e-3));
        const auto mesh = voxelize(surface, voxels_of(0.001));
        ASSERT_TRUE(mesh) << mesh.error().text();
        const QualityReport report = mesh_quality(*mesh, &surface);
        // Each wall may be off by half a cell; curved and slanted ones average out.
        const double half_a_cell = 0.5 * 0.001 * check_surface(surface).area;
        EXPECT_LT(std::abs(*report.volume_error) * report.volume, 0.5 * half_a_cell) << path;
        EXPECT_EQ(report.components, 1) << path;
    }
}

}  // namespace
}  // namespace myo::mesh
