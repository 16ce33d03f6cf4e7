#include <gtest/gtest.h>

#include <set>

#include "base/decompositions.hpp"
#include "fem/element_block.hpp"
#include "support/meshes.hpp"

namespace myo::fem {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

TEST(ElementBlock, NamesGoThereAndBack) {
    std::set<std::string> ids;
    for (const std::string& id : element_ids()) {
        ElementKind kind{};
        EXPECT_TRUE(ids.insert(id).second);
        ASSERT_TRUE(parse_element(id, kind));
        EXPECT_EQ(to_string(kind), id);
    }
    ElementKind kind = ElementKind::tet4;
    EXPECT_FALSE(parse_element("hex9", kind));
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10})
        EXPECT_EQ(cell_type(default_element(type)), type);
}

TEST(ElementBlock, AFineElementHasTheSameNodesAndIsItsOwn) {
    EXPECT_EQ(fine_element(ElementKind::tet10), ElementKind::tet10_fine);
    for (const std::string& id : element_ids()) {
        const ElementKind kind = test::element(id), fine = fine_element(kind);
        EXPECT_EQ(cell_type(fine), cell_type(kind)) << id;
        EXPECT_EQ(fine_element(fine), fine) << id;
    }
}

TEST(ElementBlock, VolumesAreTheMeshsAndGradientsReproduceLinearFields) {
    Matrix3d A;
    A << 0.9, 0.3, -0.2, 0.1, 1.2, 0.4, -0.5, 0.2, 0.8;
    for (const std::string& id : element_ids()) {
        const ElementKind kind = test::element(id);
        const mesh::VolumeMesh mesh = test::distorted_mesh(cell_type(kind), {2, 2, 2}, 0.2);
        const Eigen::VectorXd volumes = mesh::cell_volumes(mesh);
        const Eigen::Matrix3Xd x = test::mapped(mesh, A, {3.0, -1.0, 2.0});
        std::visit(
            [&](const auto& block) {
                for (int c = 0; c < block.cell_count(); ++c) {
                    const auto& geometry = block.geometry[static_cast<std::size_t>(c)];
                    EXPECT_NEAR(geometry.volume, volumes(c), 1e-14) << id;
                    const MatrixXd cell = x(Eigen::all, block.cells.col(c));
                    if constexpr (requires { geometry.weight; }) {
                        double sum = 0.0;
                        for (std::size_t q = 0; q < geometry.gradient.size(); ++q) {
                            sum += geometry.weight[q];
                            EXPECT_LT((cell * geometry.gradient[q] - A).norm(), 1e-12) << id;
                        }
                        EXPECT_NEAR(sum, geometry.volume, 1e-15) << id;
                    } else {
                        EXPECT_LT((cell * geometry.gradient - A).norm(), 1e-12) << id;
                    }
                }
            },
            make_elements(mesh, kind));
    }
}

/// Consistent mass against the closed moments of the box: exact for the quadratic and linear fields the elements hold.
TEST(ConsistentMass, HasTheExactMomentsOfTheBody) {
    const Vector3d L = test::unit_box().size();
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10}) {
        mesh::VolumeMesh mesh = test::box_mesh(default_element(type), test::unit_box(), {2, 2, 2});
        // Moving inner nodes only keeps the body.
        std::mt19937 random(2);
        std::uniform_real_distribution<double> shift(-0.03, 0.03);
        if (type != mesh::CellType::tet10)
            for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
                if (((mesh.nodes.col(i).array() > 1e-9) && (mesh.nodes.col(i).array() < L.array() - 1e-9)).all())
                    mesh.nodes.col(i) += Vector3d(shift(random), shift(random), shift(random));
        MatrixXd M = MatrixXd::Zero(mesh.node_count(), mesh.node_count());
        for (const MassEntry& entry : consistent_mass(mesh)) M(entry.row, entry.column) += entry.value;
        EXPECT_LT((M - M.transpose()).norm(), 1e-15 * M.norm());
        EXPECT_GT(symmetric_eigenvalues(M).minCoeff(), 0.0);
        const MatrixXd X = mesh.nodes.transpose();
        const Eigen::VectorXd one = Eigen::VectorXd::Ones(mesh.node_count());
        const double volume = L.prod();
        EXPECT_NEAR(one.dot(M * one), volume, 1e-13);
        for (int r = 0; r < 3; ++r) {
            EXPECT_NEAR(one.dot(M * X.col(r)), volume * L(r) / 2.0, 1e-13) << to_string(type);
            EXPECT_NEAR(X.col(r).dot(M * X.col(r)), volume * L(r) * L(r) / 3.0, 1e-13) << to_string(type);
            const int s = (r + 1) % 3;
            EXPECT_NEAR(X.col(r).dot(M * X.col(s)), volume * L(r) * L(s) / 4.0, 1e-13) << to_string(type);
        }
        if (type == mesh::CellType::tet10) {  // x^2 is in its space; its square has degree 4
            const Eigen::VectorXd square = X.col(0).cwiseAbs2();
            EXPECT_NEAR(square.dot(M * square), volume * std::pow(L(0), 4) / 5.0, 1e-13);
        }
    }
}

}  // namespace
}  // namespace myo::fem
