#pragma once

#include <Eigen/Core>

namespace myo::effect {

/// Unit vector at two angles from a base direction.
///
/// A direction has two degrees of freedom. It is parametrised by the components of the rotation vector perpendicular to
/// the base, i.e. by the exponential map of the sphere (Absil, Mahony & Sepulchre 2008, Optimization Algorithms on
/// Matrix Manifolds, 5.4). Zero angles give the base itself; the norm of the angles is the angle between the two.
///
/// @param base        unit vector
/// @param angles_rad  components [rad]
Eigen::Vector3d direction_at(const Eigen::Vector3d& base, const Eigen::Vector2d& angles_rad);

/// Inverse of direction_at(). `direction` may have any non-zero length; for -base the result is half a turn about the
/// first axis.
Eigen::Vector2d direction_angles(const Eigen::Vector3d& base, const Eigen::Vector3d& direction);

}  // namespace myo::effect
