#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "mesh/surface_check.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/voxel_mesh.hpp"

namespace myo::mesh {
namespace {

TEST(Quality, PerfectCells) {
    const QualityReport cubes = mesh_quality(box_hex_mesh({{0, 0, 0}, {0.02, 0.01, 0.01}}, {2, 1, 1}));
    EXPECT_NEAR(cubes.least, 1.0, 1e-14);
    EXPECT_EQ(cubes.histogram[9], 2);
    EXPECT_NEAR(cubes.min_dihedral_deg, 90.0, 1e-12);
    EXPECT_NEAR(cubes.mean_edge, 0.01, 1e-16);
    EXPECT_EQ(cubes.dofs, 36);

    VolumeMesh regular{CellType::tet4, Eigen::Matrix3Xd(3, 4), Eigen::MatrixXi(4, 1)};
    regular.nodes << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
    regular.cells << 0, 1, 2, 3;
    ASSERT_GT(cell_volumes(regular)[0], 0.0);
    const QualityReport report = mesh_quality(regular);
    EXPECT_NEAR(report.least, 1.0, 1e-14);
    EXPECT_NEAR(report.min_dihedral_deg, std::acos(1.0 / 3.0) * 180.0 / M_PI, 1e-10);
    EXPECT_NEAR(report.largest_dihedral_deg, report.min_dihedral_deg, 1e-10);
    std::swap(regular.cells(0, 0), regular.cells(1, 0));
    EXPECT_NEAR(mesh_quality(regular).least, -1.0, 1e-14);
    EXPECT_FALSE(mesh_quality(regular).messages.empty());
}

TEST(Quality, ShearedHexahedron) {
    // Sheared by 45 degrees: the corner Jacobian over the edge lengths is 1 / sqrt(2).
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1});
    mesh.nodes.row(0) += mesh.nodes.row(2).eval();
    const QualityReport report = mesh_quality(mesh);
    EXPECT_NEAR(report.least, std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(report.min_dihedral_deg, 45.0, 1e-10);
    EXPECT_NEAR(report.largest_dihedral_deg, 135.0, 1e-10);
    EXPECT_EQ(report.histogram[7], 1);
}

TEST(Quality, HistogramCountsEveryCell) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const QualityReport report = mesh_quality(test::bent(mesh, 6.0));
        EXPECT_EQ(std::accumulate(report.histogram.begin(), report.histogram.end(), 0), mesh.cell_count());
        EXPECT_LE(report.least, report.mean);
    }
}

TEST(Estimate, ExactForABoxOfHexahedra) {
    const SurfaceMesh box = box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    const CountEstimate estimate = estimate_counts(box, CellType::hex8, 0.004);
    EXPECT_TRUE(estimate.exact);
    EXPECT_EQ(estimate.cells, 25 * 8 * 8);
    EXPECT_EQ(estimate.dofs, 3 * 26 * 9 * 9);
}

TEST(Estimate, NearForRoundBodies) {
    for (const SurfaceMesh& surface : {test::cylinder(48, 0.02, 0.05), weld(test::sphere(4, 0.025))}) {
        VoxelOptions options;
        options.edge = 0.003;
        const auto mesh = voxelize(surface, options);
        ASSERT_TRUE(mesh);
        const CountEstimate estimate = estimate_counts(surface, CellType::hex8, options.edge);
        EXPECT_NEAR(estimate.cells, static_cast<double>(mesh->cell_count()), 0.1 * estimate.cells);
        EXPECT_NEAR(estimate.nodes, static_cast<double>(mesh->node_count()), 0.1 * estimate.nodes);
    }
}

TEST(Quality, FlatCellsAreCountedAndPlaced) {
    VolumeMesh mesh{CellType::tet4, Eigen::Matrix3Xd(3, 5), Eigen::MatrixXi(4, 2)};
    mesh.nodes << 0, 0.01, 0, 0, 0.003, 0, 0, 0.01, 0, 0.003, 0, 0, 0, 0.01, 0;
    mesh.cells << 0, 0, 1, 2, 2, 1, 3, 4;
    mesh.nodes(2, 4) = -0.004;
    EXPECT_TRUE(mesh_quality(mesh).messages.empty());
    mesh.nodes(2, 4) = -1e-6;
    const QualityReport report = mesh_quality(mesh);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].find("1 of 2 cells is almost flat (mean ratio below 0.02), the worst with"),
              std::string::npos)
        << report.messages[0];
    EXPECT_NE(report.messages[0].find("cell 1 at (3.25, 3.25, -0.00025) mm"), std::string::npos) << report.messages[0];
}

}  // namespace
}  // namespace myo::mesh
