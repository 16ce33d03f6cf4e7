#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::model {

/// Rotation of the material at each node.
///
/// @param x  node positions, 3 x n [m]
/// @return   9 x n, a column-major 3 x 3 rotation per column: polar rotation of the volume-weighted mean deformation
///           gradient of the adjacent cells; identity if that mean is degenerate
Eigen::Matrix<double, 9, Eigen::Dynamic> nodal_rotations(const Body& body, const Eigen::Matrix3Xd& x);

}  // namespace myo::model
