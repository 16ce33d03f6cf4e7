#pragma once

#include <Eigen/Core>

namespace myo::effect {

/// A direction has two degrees of freedom: it is described by two angles [rad] about a base direction, the components
/// of the rotation vector across it (the exponential map of the sphere; Absil, Mahony & Sepulchre 2008, Optimization
/// Algorithms on Matrix Manifolds, 5.4). Zero angles are the base itself; their length is the angle between the two.
///
/// @param base  unit vector
Eigen::Vector3d direction_at(const Eigen::Vector3d& base, const Eigen::Vector2d& angles_rad);

/// The angles of a direction of any length but zero; of the base's opposite, half a turn about the first axis.
Eigen::Vector2d direction_angles(const Eigen::Vector3d& base, const Eigen::Vector3d& direction);

}  // namespace myo::effect
