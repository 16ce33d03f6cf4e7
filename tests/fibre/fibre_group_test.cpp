#include <gtest/gtest.h>

#include "fibre/fibre_group.hpp"
#include "support/differences.hpp"
#include "support/meshes.hpp"

namespace myo::fibre {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d stretch_vector(const FibrePoint& point, const Eigen::MatrixXi& cells, const Eigen::Matrix3Xd& x) {
    Vector3d s = Vector3d::Zero();
    for (int a = 0; a < point.shape.size(); ++a) s += point.shape(a) * x.col(cells(a, point.cell));
    return s;
}

TEST(FibreResponse, AgreesWithDifferences) {
    constexpr double w = 3.0;
    for (const double a : {-2.0, 0.6, 1.0, 1.7})
        for (const Vector3d& s : {Vector3d(1, 0, 0), Vector3d(0.3, -0.8, 0.5), Vector3d(1.5, 1.0, -2.0)}) {
            const FibreResponse r = fibre_response(s, a, w);
            const auto energy = [&](const VectorXd& v) {
                return VectorXd::Constant(1, fibre_response(v, a, w).energy);
            };
            const auto gradient = [&](const VectorXd& v) { return VectorXd(fibre_response(v, a, w).gradient); };
            const auto at_activation = [&](const VectorXd& v) { return VectorXd(fibre_response(s, v(0), w).gradient); };
            if (r.gradient.norm() > 0.0)
                test::expect_derivative(r.gradient.transpose(), test::central_differences(energy, s, 1e-5), 1e-8,
                                        "gradient");
            test::expect_derivative(r.hessian, test::central_differences(gradient, s, 1e-5), 1e-8, "Hessian");
            test::expect_equal_to_differences(r.gradient_activation,
                                              test::central_differences(at_activation, VectorXd::Constant(1, a), 1e-3),
                                              1e-10, "da");
            EXPECT_LT((r.hessian - r.hessian.transpose()).norm(), 1e-15 * r.hessian.norm());
        }
}

/// a is the target stretch: no force there, pull when longer, push when shorter; rotating the fibre rotates the force.
TEST(FibreResponse, ActivationIsTheTargetStretch) {
    const Vector3d m(0.0, 0.6, 0.8);
    EXPECT_LT(fibre_response(0.8 * m, 0.8, 5.0).gradient.norm(), 1e-15);
    EXPECT_NEAR(fibre_response(m, 0.8, 5.0).gradient.dot(m), 5.0 * 0.2, 1e-15);
    EXPECT_NEAR(fibre_response(m, 1.3, 5.0).gradient.dot(m), -5.0 * 0.3, 1e-15);
    const Matrix3d Q = Eigen::AngleAxisd(1.1, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    const FibreResponse r = fibre_response(1.2 * m, 0.8, 5.0), rotated = fibre_response(Q * m * 1.2, 0.8, 5.0);
    EXPECT_NEAR(r.energy, rotated.energy, 1e-15);
    EXPECT_LT((rotated.gradient - Q * r.gradient).norm(), 1e-14);
    EXPECT_LT((rotated.hessian - Q * r.hessian * Q.transpose()).norm(), 1e-14);
}

TEST(FibresInBox, HaveTheVolumeAndSeeLinearFieldsExactly) {
    Matrix3d A;
    A << 0.9, 0.3, -0.2, 0.1, 1.2, 0.4, -0.5, 0.2, 0.8;
    const Vector3d m = Vector3d(1, 2, -1).normalized();
    const Box whole{{-1, -1, -1}, {2, 2, 2}};
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = test::distorted_mesh(type, {2, 2, 2}, 0.15);
        const FibreGroup group = fibres_in_box(mesh, whole, m, 2.0, "all");
        EXPECT_NEAR(group.volume(), mesh::cell_volumes(mesh).sum(), 1e-12) << to_string(type);
        const Eigen::Matrix3Xd x = test::mapped(mesh, A, {5, 6, 7});
        for (const FibrePoint& point : group.points)
            EXPECT_LT((stretch_vector(point, mesh.cells, x) - A * m).norm(), 1e-12);
    }
}

/// A slab thinner than a cell: volume, centroid and second moment of the fibre field are those of the slab, on any mesh
/// of hexahedra or quadratic tetrahedra, upright or oblique.
TEST(FibresInBox, ThinSlabBendsAsItShould) {
    const Box slab{{0.3, 0.0, 0.05}, {0.9, 0.8, 0.15}};
    const Vector3d m = Vector3d::UnitX();
    std::vector<mesh::VolumeMesh> meshes;
    for (const Eigen::Vector3i& cells :
         {Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(3, 2, 2), Eigen::Vector3i(10, 4, 12)})
        for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
            meshes.push_back(test::box_mesh(element, test::unit_box(), cells));
            // A parallelogram in plan: the bilinear motion below is still one of the element.
            mesh::VolumeMesh oblique = meshes.back();
            oblique.nodes.row(0) += 0.3 * oblique.nodes.row(1);
            meshes.push_back(std::move(oblique));
        }
    for (const mesh::VolumeMesh& mesh : meshes) {
        const FibreGroup group = fibres_in_box(mesh, slab, m, 2.0, "slab");
        const double volume = slab.size().prod();
        EXPECT_NEAR(group.volume(), volume, 1e-14);
        // Under x = X + z X e_x the stretch of a fibre along x is 1 + z: its moments measure where the fibres lie.
        Eigen::Matrix3Xd x = mesh.nodes;
        x.row(0) += mesh.nodes.row(2).cwiseProduct(mesh.nodes.row(0));
        double first = 0.0, second = 0.0;
        for (const FibrePoint& point : group.points) {
            const double z = stretch_vector(point, mesh.cells, x)(0) - 1.0;
            first += point.volume * z;
            second += point.volume * z * z;
        }
        EXPECT_NEAR(first / volume, 0.10, 1e-12);
        EXPECT_NEAR(second / volume, 0.10 * 0.10 + 0.10 * 0.10 / 12.0, 1e-12);
    }
    EXPECT_TRUE(fibres_in_box(mesh::box_hex_mesh(test::unit_box(), {2, 2, 2}), Box{{2, 2, 2}, {3, 3, 3}}, m, 1.0, "out")
                    .points.empty());
}

TEST(FibresInBox, OtherCellsKeepTheVolumeInsideTheBox) {
    const Box slab{{0.0, 0.0, 0.0}, {1.0, 0.8, 0.2}};
    for (const mesh::CellType type : {mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = mesh::tet_box_mesh(test::unit_box(), {3, 2, 2}, type);
        EXPECT_NEAR(fibres_in_box(mesh, slab, Vector3d::UnitX(), 1.0, "slab").volume(), slab.size().prod(), 1e-12)
            << to_string(type);
    }
}

}  // namespace
}  // namespace myo::fibre
