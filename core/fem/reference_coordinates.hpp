#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "mesh/cells.hpp"

namespace myo::fem {

/// Reference coordinates of a point in a cell by Newton's method.
///
/// @param X        nodes of the cell [m], 3 x Shape::nodes, in the order of the shape functions
/// @param point_m  point inside the cell or close to it
/// Errors: none. Without convergence in 30 iterations the last iterate is returned.
template <class Shape>
Eigen::Vector3d reference_coordinates(const Eigen::Matrix3Xd& X, const Eigen::Vector3d& point_m) {
    Eigen::Vector3d xi = Shape::reference_centroid();
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
    return mesh::with_cell(mesh.type, [&]<class Shape>(Shape) { return reference_coordinates<Shape>(X, point_m); });
}

}  // namespace myo::fem
