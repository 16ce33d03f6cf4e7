#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::model {

/// Rotation of the material at each node, 9 x n, a 3 x 3 matrix per column (column-major): the rotation nearest to the
/// mean of the deformation gradients of the cells around it. The identity where that mean is degenerate.
Eigen::Matrix<double, 9, Eigen::Dynamic> nodal_rotations(const Body& body, const Eigen::Matrix3Xd& x);

}  // namespace myo::model
