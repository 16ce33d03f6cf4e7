#pragma once

#include "fibre/fibre_group.hpp"
#include "support/meshes.hpp"

namespace myo::test {

/// Forces of a group on the nodes at positions x and activation a, 3 x n [N].
inline Eigen::Matrix3Xd fibre_forces(const mesh::VolumeMesh& mesh, const fibre::FibreGroup& group,
                                     const Eigen::Matrix3Xd& x, double a) {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, x.cols());
    for (const fibre::FibrePoint& point : group.points) {
        Eigen::Vector3d s = Eigen::Vector3d::Zero();
        for (int n = 0; n < point.shape.size(); ++n) s += point.shape(n) * x.col(mesh.cells(n, point.cell));
        const Eigen::Vector3d g = fibre::fibre_response(s, a, group.stiffness_Pa).gradient;
        for (int n = 0; n < point.shape.size(); ++n)
            forces.col(mesh.cells(n, point.cell)) -= point.volume * point.shape(n) * g;
    }
    return forces;
}

/// A smooth bend and stretch of the unit box.
inline Eigen::Matrix3Xd bent(const mesh::VolumeMesh& mesh) {
    Eigen::Matrix3Xd x = mesh.nodes;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        const Eigen::Vector3d X = mesh.nodes.col(i);
        x.col(i) += 0.1 * Eigen::Vector3d(X(2) * X(0), 0.3 * X(0), 0.5 * X(0) * X(0) - X(2) * X(1));
    }
    return x;
}

/// Work of forces along some smooth motions: what a body feels of them, whatever its mesh.
inline Eigen::Vector4d work(const mesh::VolumeMesh& mesh, const Eigen::Matrix3Xd& forces) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (Eigen::Index i = 0; i < forces.cols(); ++i) {
        const Eigen::Vector3d X = mesh.nodes.col(i), f = forces.col(i);
        sum += Eigen::Vector4d(f(0) * X(0), f(0) * X(0) * X(2), f(1) * X(0), f(2) * X(0) * X(0));
    }
    return sum;
}

inline double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).norm() / b.norm();
}

inline mesh::VolumeMesh mesh_of(mesh::CellType type, const Eigen::Vector3i& cells) {
    return type == mesh::CellType::hex8 ? mesh::box_hex_mesh(unit_box(), cells)
                                        : mesh::tet_box_mesh(unit_box(), cells, type);
}

constexpr mesh::CellType all_cell_types[] = {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10};

}  // namespace myo::test
