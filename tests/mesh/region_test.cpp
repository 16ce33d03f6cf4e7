#include "mesh/region.hpp"

#include <gtest/gtest.h>

#include "mesh/test_meshes.hpp"

namespace myo::mesh {
namespace {

const Box everything{{-1, -1, -1}, {1, 1, 1}};

TEST(SurfaceWeights, WholeBoundaryOfABox) {
    const Eigen::Vector3d s = test::unequal_box().size();
    const double area = 2.0 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const SurfaceIntegral integral = surface_weights(mesh, boundary_faces(mesh), everything);
        EXPECT_NEAR(integral.area, area, 1e-13 * area);
        EXPECT_NEAR(integral.weight.sum(), area, 1e-13 * area);
    }
}

// Weights must give the area and the centroid of the part exactly, for linear functions of position.
void expect_linear_exact(const VolumeMesh& mesh, const Box& box, double area, const Eigen::Vector3d& centroid) {
    const SurfaceIntegral integral = surface_weights(mesh, boundary_faces(mesh), box);
    EXPECT_NEAR(integral.area, area, 1e-12 * area) << to_string(mesh.type);
    EXPECT_NEAR(integral.weight.sum(), area, 1e-12 * area) << to_string(mesh.type);
    EXPECT_LT((mesh.nodes * integral.weight / area - centroid).norm(), 1e-13) << to_string(mesh.type);
}

TEST(SurfaceWeights, BoxThinnerThanACell) {
    // A strip 1 mm high on the tip face x = 0.05, cells are 20 mm high.
    const Box strip{{0.0499, 0.0, 0.031}, {0.0501, 1.0, 0.032}};
    for (const VolumeMesh& mesh : test::one_of_each()) {
        // the strip, and the slivers of the two side faces y = 0.02, 0.04 between x = 0.0499 and 0.05
        const double face = 0.02 * 0.001, side = 1e-4 * 0.001;
        const Eigen::Vector3d centroid = (face * Eigen::Vector3d(0.05, 0.03, 0.0315) +
                                          2 * side * Eigen::Vector3d(0.04995, 0.03, 0.0315)) /
                                         (face + 2 * side);
        expect_linear_exact(mesh, strip, face + 2 * side, centroid);
    }
}

TEST(SurfaceWeights, FaceLyingInABoxFaceCountsOnce) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const Box sheet{{0.05, 0.0, 0.0}, {0.05, 1.0, 1.0}};
        expect_linear_exact(mesh, sheet, 0.02 * 0.04, {0.05, 0.03, 0.025});
        const Box outside{{0.05 + 1e-6, 0.0, 0.0}, {1.0, 1.0, 1.0}};
        EXPECT_EQ(surface_weights(mesh, boundary_faces(mesh), outside).area, 0.0);
    }
}

TEST(SurfaceWeights, BilinearFunctionIsIntegratedExactly) {
    // One cell; integral over u in [0, 0.3], v in [0, 0.5] of u v = 0.045 * 0.125
    const VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1});
    const SurfaceIntegral integral = surface_weights(mesh, boundary_faces(mesh), {{1, 0, 0}, {1, 0.3, 0.5}});
    EXPECT_NEAR(integral.weight[7], 0.045 * 0.125, 1e-15);  // node (1,1,1) carries u v
}

TEST(SurfaceWeights, QuadraticFunctionOnTet10IsExact) {
    const VolumeMesh mesh = tet_box_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1}, CellType::tet10);
    const SurfaceIntegral integral = surface_weights(mesh, boundary_faces(mesh), {{1, 0, 0}, {1, 0.3, 0.5}});
    const Eigen::VectorXd f = mesh.nodes.row(1).array().square() +
                              mesh.nodes.row(1).array() * mesh.nodes.row(2).array();
    EXPECT_NEAR(integral.weight.dot(f), 0.009 * 0.5 + 0.045 * 0.125, 1e-15);
}

TEST(SurfaceWeights, TrapezoidFaceUsesTheInverseBilinearMap) {
    // A planar trapezoid face: partition of unity, and x = sum N X holds, so linear functions stay exact.
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1});
    for (Eigen::Index i = 0; i < 8; ++i) mesh.nodes(1, i) *= 1.0 - 0.5 * mesh.nodes(2, i);
    const Box box{{1, 0, 0}, {1, 0.4, 1}};  // the face x = 1 cut at y = 0.4: a rectangle
    const SurfaceIntegral integral = surface_weights(mesh, boundary_faces(mesh), box);
    EXPECT_NEAR(integral.area, 0.4, 1e-14);
    EXPECT_LT((mesh.nodes * integral.weight / 0.4 - Eigen::Vector3d(1, 0.2, 0.5)).norm(), 1e-13);
}

TEST(VolumeFractions, AddUpToTheOverlap) {
    const Box part{{0.003, 0.0, 0.011}, {0.029, 0.033, 0.1}};
    const double overlap = 0.026 * 0.013 * 0.034;
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const Eigen::VectorXd fractions = volume_fractions(mesh, part);
        EXPECT_GE(fractions.minCoeff(), 0.0);
        EXPECT_LE(fractions.maxCoeff(), 1.0);
        EXPECT_NEAR(fractions.dot(cell_volumes(mesh)), overlap, 1e-12 * overlap) << to_string(mesh.type);
        EXPECT_NEAR(volume_fractions(mesh, everything).minCoeff(), 1.0, 1e-12);
    }
}

TEST(VolumeFractions, DistortedCellsAddUpOverASplitBox) {
    for (const VolumeMesh& straight : test::one_of_each()) {
        const VolumeMesh mesh = test::rotated(test::bent(straight, 4.0));
        const Eigen::VectorXd below = volume_fractions(mesh, {{-1, -1, -1}, {1, 1, 0.02}});
        const Eigen::VectorXd above = volume_fractions(mesh, {{-1, -1, 0.02}, {1, 1, 1}});
        EXPECT_LT((below + above - Eigen::VectorXd::Ones(mesh.cell_count())).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_GT(below.maxCoeff(), 0.5);
        EXPECT_GT(above.maxCoeff(), 0.5);
    }
}

TEST(NodesInBox, IncludesTheFace) {
    const VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {0.1, 0.03, 0.03}}, {10, 3, 3});
    EXPECT_EQ(nodes_in_box(mesh, {{-5e-4, -1e-3, -1e-3}, {5e-4, 0.031, 0.031}}).size(), 16u);
    EXPECT_EQ(nodes_in_box(mesh, {{0.1, 0, 0}, {0.2, 0.03, 0.03}}).size(), 16u);
}

}  // namespace
}  // namespace myo::mesh
