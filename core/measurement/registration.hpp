#pragma once

#include <Eigen/Core>

#include "base/result.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// Rigid motion between two sets of corresponding points, with its residuals.
struct Registration {
    RigidMotion motion;           // frame of `from` -> frame of `to`
    Eigen::Matrix3Xd residual_m;  // 3 x n, motion(from) - to, in the frame of `to`
    Eigen::VectorXd distance_m;   // n, lengths of the residuals
    double rms_m = 0.0;           // weighted root mean square of the distances
};

/// Rigid motion (no scale, no reflection) that minimises the weighted sum of squared distances.
///
/// @param from, to  3 x n corresponding points [m]
/// @param weights   n, not negative; empty: equal weights. A point of weight 0 does not contribute but gets a residual
/// Errors: fewer than three points with positive weight; collinear points (width below 1e-4 of the length); values that
/// are not finite.
/// Source: Kabsch 1976; Umeyama 1991 for the sign of the determinant.
Result<Registration> rigid_registration(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                        const Eigen::VectorXd& weights = Eigen::VectorXd());

/// Derivative of the motion by the points `to`: the small rigid motion that follows it when they are displaced.
///
/// @return  6 x 3 n: translation [m] and rotation vector about the origin [rad] by x, y, z of each point [m]; exact
///          where the residuals vanish
/// Errors: none; the points must be such that rigid_registration() accepts them.
Eigen::MatrixXd d_registration_d_to(const Eigen::Matrix3Xd& to, const Eigen::VectorXd& weights);

}  // namespace myo::measurement
