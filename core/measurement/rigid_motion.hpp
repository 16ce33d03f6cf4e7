#pragma once

#include <Eigen/Core>

#include "base/cross_matrix.hpp"

namespace myo::measurement {

/// A rigid motion p -> R p + t, from one frame to another; translation in m.
struct RigidMotion {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d apply(const Eigen::Vector3d& p) const;
    /// Every column of a 3 x n array; NaN columns stay NaN.
    Eigen::Matrix3Xd apply_all(const Eigen::Matrix3Xd& points) const;
    RigidMotion inverse() const;
};

/// The motion that does `first`, then `second`.
RigidMotion compose(const RigidMotion& second, const RigidMotion& first);

/// Angle of a rotation matrix [rad], 0 to pi; exact for small angles too.
double rotation_angle(const Eigen::Matrix3d& rotation);

/// Rotation about the axis omega by |omega| [rad]: the exponential map, smooth through zero.
Eigen::Matrix3d small_rotation(const Eigen::Vector3d& omega);

/// d(R(omega) p) / d omega, 3 x 3, at any omega: -[R p]x J with J the left Jacobian of the rotation group.
/// Source: Sola, Deray, Atchuthan 2018, "A micro Lie theory", eq. 145.
Eigen::Matrix3d d_rotated_d_omega(const Eigen::Vector3d& omega, const Eigen::Vector3d& p);

}  // namespace myo::measurement
