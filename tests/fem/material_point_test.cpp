#include "fem/material_point.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace myo::fem {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Bending along x with a quadratic deflection, which tet10 follows everywhere.
Matrix3Xd bent(const Matrix3Xd& X) {
    Matrix3Xd x = X;
    x.row(2) += 3.0 * X.row(0).cwiseAbs2();
    return x;
}

mesh::VolumeMesh block(ElementKind kind) { return test::box_mesh(kind, Box{{0, 0, 0}, {0.06, 0.02, 0.02}}, {6, 2, 2}); }

TEST(MaterialPoint, StaysWhereItIsAtRestInsideAndOutside) {
    for (const ElementKind kind : {ElementKind::hex8, ElementKind::tet4, ElementKind::tet10}) {
        const mesh::VolumeMesh mesh = block(kind);
        const mesh::BoundaryLocator boundary(mesh);
        for (const Vector3d& rest : {Vector3d(0.031, 0.012, 0.004), Vector3d(0.05, 0.02, 0.01), Vector3d(0.0, 0.0, 0.0),
                                     Vector3d(0.03, 0.01, 0.027), Vector3d(0.07, -0.004, 0.03)}) {
            const MaterialPoint point = material_point(mesh, boundary, rest);
            EXPECT_NEAR(point.weights.sum(), 1.0, 1e-12);
            EXPECT_LT((mesh.nodes(Eigen::all, point.nodes) * point.weights - rest).norm(), 1e-12) << to_string(kind);
            EXPECT_LT((mesh.nodes(Eigen::all, point.nodes) * point.gradient - Matrix3d::Identity()).norm(), 1e-9);
        }
    }
}

TEST(MaterialPoint, MovesWithTheMaterialAndLinearlyBeyondIt) {
    const mesh::VolumeMesh mesh = block(ElementKind::tet10);
    const mesh::BoundaryLocator boundary(mesh);
    const Matrix3Xd x = bent(mesh.nodes);
    const auto place = [&](const Vector3d& rest) {
        const MaterialPoint point = material_point(mesh, boundary, rest);
        return Vector3d(x(Eigen::all, point.nodes) * point.weights);
    };
    const Vector3d inside(0.031, 0.012, 0.004);
    EXPECT_LT((place(inside) - bent(inside).col(0)).norm(), 1e-12);
    // Beyond the end face: along its tangent, not along the parabola.
    const Vector3d end(0.06, 0.01, 0.01), beyond = end + Vector3d(0.02, 0.0, 0.0);
    EXPECT_LT((place(beyond) - (bent(end).col(0) + Vector3d(0.02, 0.0, 0.02 * 6.0 * 0.06))).norm(), 1e-10);
}

}  // namespace
}  // namespace myo::fem
