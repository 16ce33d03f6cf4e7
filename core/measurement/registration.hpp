#pragma once

#include <Eigen/Core>

#include "base/result.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// The rigid motion between two sets of corresponding points, and how well it fits.
struct Registration {
    RigidMotion motion;           // from -> to
    Eigen::Matrix3Xd residual_m;  // 3 x n, motion(from) - to, in the frame of `to`
    Eigen::VectorXd distance_m;   // n, length of each residual
    double rms_m = 0.0;           // weighted root mean square of the distances (all three coordinates together)
};

/// Rotation and translation, no scale and no reflection, with the least weighted sum of squared distances.
///
/// @param from, to  3 x n corresponding points [m]
/// @param weights   n, not negative; empty = all equal. A point with weight 0 does not pull, but gets a residual
/// Errors: fewer than three points with weight, points on one line (wider than 1e-4 of its length across counts as not
/// on a line), values that are not finite. Source: Kabsch 1976; Umeyama 1991 for the sign of the determinant.
Result<Registration> rigid_registration(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                        const Eigen::VectorXd& weights = Eigen::VectorXd());

}  // namespace myo::measurement
