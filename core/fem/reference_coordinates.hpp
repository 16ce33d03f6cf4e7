#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "fem/shape_functions.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// Reference coordinates of a point in a cell by Newton's method.
///
/// @param X        nodes of the cell [m], 3 x Shape::nodes, in the order of the shape functions
/// @param point_m  point inside the cell or close to it
/// @param middle   initial value well inside the cell
/// Errors: none. Without convergence in 30 iterations the last iterate is returned.
template <class Shape>
Eigen::Vector3d reference_coordinates(const Eigen::Matrix3Xd& X, const Eigen::Vector3d& point_m,
                                      const Eigen::Vector3d& middle) {
    Eigen::Vector3d xi = middle;
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Eigen::Vector3d error = point_m - X * Shape::values(xi);
        const Eigen::Vector3d step = (X * Shape::derivatives(xi)).inverse() * error;
        xi += step;
        if (step.norm() < 1e-14) break;
    }
    return xi;
}

/// Reference coordinates of a point in a cell of a mesh.
inline Eigen::Vector3d reference_coordinates(const mesh::VolumeMesh& mesh, int cell, const Eigen::Vector3d& point_m) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(cell));
    const Eigen::Vector3d in_tetrahedron = Eigen::Vector3d::Constant(0.25);
    switch (mesh.type) {
        case mesh::CellType::tet4: return reference_coordinates<Tet4>(X, point_m, in_tetrahedron);
        case mesh::CellType::tet10: return reference_coordinates<Tet10>(X, point_m, in_tetrahedron);
        default: return reference_coordinates<Hex8>(X, point_m, Eigen::Vector3d::Zero());
    }
}

}  // namespace myo::fem
