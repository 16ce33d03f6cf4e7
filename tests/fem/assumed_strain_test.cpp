#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fem/element_block.hpp"
#include "fem/reference_points.hpp"
#include "support/dense.hpp"
#include "support/meshes.hpp"

namespace myo::fem {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Matrix3d tensor(const Eigen::Matrix<double, 6, 1>& s) {
    Matrix3d A;
    A << s(0), s(3), s(5), s(3), s(1), s(4), s(5), s(4), s(2);
    return A;
}

AssumedStrainBlock distorted_block() {
    return assumed_strain_block(test::distorted_mesh(mesh::CellType::hex8, {2, 2, 2}, 0.2), {});
}

/// The shapes see no linear field, and there are as many as a mean gradient cannot see.
TEST(AssumedStrain, ShapesAreOrthogonalToLinearFields) {
    const mesh::VolumeMesh mesh = test::distorted_mesh(mesh::CellType::hex8, {2, 2, 2}, 0.2);
    const AssumedStrainBlock block = assumed_strain_block(mesh, {});
    for (int c = 0; c < block.cell_count(); ++c) {
        const AssumedStrainGeometry& cell = block.geometry[static_cast<std::size_t>(c)];
        const MatrixXd X = mesh.nodes(Eigen::all, mesh.cells.col(c));
        EXPECT_LT((X * cell.gamma).norm(), 1e-14);
        EXPECT_LT(cell.gamma.colwise().sum().norm(), 1e-14);
        MatrixXd all(8, 8);
        all << MatrixXd::Ones(8, 1), X.transpose(), cell.gamma;
        EXPECT_EQ(test::rank(all), 8);
    }
}

/// In a plane of oblique edges the strain has the covariant components that it is given, and nothing of it across.
TEST(AssumedStrain, PlanesHaveTheStrainOfTheirEdgesAndNoneAcross) {
    const AssumedStrainBlock block = distorted_block();
    for (const AssumedStrainGeometry& cell : block.geometry)
        for (int k = 0; k < 3; ++k) {
            const AssumedStrainGeometry::Plane& plane = cell.planes[static_cast<std::size_t>(k)];
            const Vector3d g_i = cell.edges.col((k + 1) % 3), g_j = cell.edges.col((k + 2) % 3),
                           n = g_i.cross(g_j).normalized();
            EXPECT_LT((tensor(plane.normal) - n * n.transpose()).norm(), 1e-13);
            for (int m = 0; m < 3; ++m) {
                const Matrix3d A = tensor(plane.in_plane.col(m));
                EXPECT_NEAR(g_i.dot(A * g_i), m == 0 ? 1.0 : 0.0, 1e-12);
                EXPECT_NEAR(g_j.dot(A * g_j), m == 1 ? 1.0 : 0.0, 1e-12);
                EXPECT_NEAR(2.0 * g_i.dot(A * g_j), m == 2 ? 1.0 : 0.0, 1e-12);
                EXPECT_LT((A * n).norm(), 1e-12 * A.norm());
                EXPECT_NEAR(A.trace(), plane.trace(m), 1e-12 * A.norm());
            }
            const Vector3d t = cell.edges.col(k);
            EXPECT_NEAR(t.dot(tensor(cell.along[static_cast<std::size_t>(k)]) * t), 1.0, 1e-12);
        }
}

/// Along an edge the rule is exact to the fourth power, and products have the mean square that their share makes right.
TEST(AssumedStrain, PointsIntegratePowersOfAStrainThatVariesLinearly) {
    using Rule = AssumedStrainRule;
    for (const auto& [power, mean] : {std::pair{0, 1.0}, {2, 1.0 / 3.0}, {4, 1.0 / 5.0}}) {
        double sum = 0.0, product = 0.0;
        for (int q = 0; q < Rule::points; ++q) {
            const Vector3d xi = assumed_strain_point(q);
            const double weight = q == 0 ? Rule::middle_weight : Rule::corner_weight;
            sum += weight * std::pow(xi.y(), power);
            product += weight * std::pow(Rule::bilinear_share * xi.x() * xi.y(), 2);
        }
        EXPECT_NEAR(sum, mean, 1e-14);
        EXPECT_NEAR(product, 1.0 / 9.0, 1e-14);
    }
}

/// Equibiaxial strain counts in full where the body ends, less between cells, least at a clamp.
TEST(AssumedStrain, EquibiaxialStrainCountsByWhatLiesBeside) {
    const mesh::VolumeMesh mesh = test::box_mesh(ElementKind::hex8, {Vector3d::Zero(), Vector3d(4.0, 1.0, 3.0)},
                                                 {4, 1, 3});
    std::vector<bool> clamped(static_cast<std::size_t>(mesh.node_count()));
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) clamped[static_cast<std::size_t>(i)] = mesh.nodes(0, i) == 0.0;
    const CellSurroundings around = cell_surroundings(mesh, clamped);
    const AssumedStrainPolicy policy;
    const AssumedStrainBlock block = assumed_strain_block(mesh, around, policy);
    for (int c = 0; c < block.cell_count(); ++c) {
        const Vector3d centre = mesh.nodes(Eigen::all, mesh.cells.col(c)).rowwise().mean();
        const auto cell = static_cast<std::size_t>(c);
        EXPECT_EQ(around[cell][0], centre.x() < 1.0   ? CellSides::clamped
                                   : centre.x() > 3.0 ? CellSides::free
                                                      : CellSides::inner);
        EXPECT_EQ(around[cell][1], CellSides::free);
        EXPECT_EQ(around[cell][2],
                  (centre.z() > 1.0 && centre.z() < 2.0) || centre.x() < 1.0 ? CellSides::inner : CellSides::free);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(block.geometry[cell].relaxed[k], policy.relaxed(around[cell][k]));
        }
    }
}

TEST(ReferencePoints, LieWhereTheRulesPutThem) {
    for (const std::string& id : element_ids()) {
        const auto values = shape_values_at_points(test::element(id));
        for (const Eigen::VectorXd& N : values) EXPECT_NEAR(N.sum(), 1.0, 1e-14) << id;
    }
    EXPECT_EQ(shape_values_at_points(ElementKind::hex8).size(), 9u);
    EXPECT_EQ(shape_values_at_points(ElementKind::tet10).size(), 4u);
}

}  // namespace
}  // namespace myo::fem
