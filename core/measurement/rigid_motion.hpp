#pragma once

#include <Eigen/Core>

#include "base/cross_matrix.hpp"

namespace myo::measurement {

/// Rigid motion p -> R p + t from one frame to another; translation in m.
struct RigidMotion {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    /// R p + t.
    Eigen::Vector3d apply(const Eigen::Vector3d& p) const;
    /// Applied to every column of a 3 x n array; NaN columns stay NaN.
    Eigen::Matrix3Xd apply_all(const Eigen::Matrix3Xd& points) const;
    /// p -> R' (p - t).
    RigidMotion inverse() const;
};

/// Composition: `first` is applied first, then `second`.
RigidMotion compose(const RigidMotion& second, const RigidMotion& first);

/// Angle of a rotation matrix [rad], 0 ... pi; accurate for small angles.
double rotation_angle(const Eigen::Matrix3d& rotation);

/// Rotation about the axis omega by the angle |omega| [rad]: exponential map, smooth at zero.
Eigen::Matrix3d small_rotation(const Eigen::Vector3d& omega);

/// Derivative d(R(omega) p) / d omega, 3 x 3, at any omega: -[R p]x J with the left Jacobian J of the rotation group.
/// Source: Sola, Deray, Atchuthan 2018, "A micro Lie theory", eq. 145.
Eigen::Matrix3d d_rotated_d_omega(const Eigen::Vector3d& omega, const Eigen::Vector3d& p);

}  // namespace myo::measurement
