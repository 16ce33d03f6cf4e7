#pragma once

#include <Eigen/Core>

#include "base/result.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// Assignment of observed points to the markers of a body.
struct MarkerMatch {
    Eigen::VectorXi seen;  // per marker of the body: column of the observed points, -1 = none
    RigidMotion motion;    // camera frame -> body frame
    double rms_m = 0.0;    // distances of the matched markers
    bool unique = true;    // false: another assignment explains as many markers equally well (symmetric arrangement)

    /// Number of matched markers.
    int count() const { return static_cast<int>((seen.array() >= 0).count()); }
};

/// Rigid motion that maps most observed points to markers at rest; among equally good motions the one closest to the
/// expected rotation.
///
/// Triples of widely spaced markers are searched among the observed points by their side lengths. Each candidate gives
/// a motion, under which the remaining markers are assigned to their nearest points. If the markers are collinear, or
/// fewer than three match, only the expected rotation is tried.
/// @param rest_m       3 x n [m], body frame
/// @param seen_m       3 x m [m], camera frame; NaN = never visible
/// @param tolerance_m  largest distance between a marker and its point
/// @param expected     rotation, camera frame -> body frame
/// Errors: no marker; no visible point.
Result<MarkerMatch> match_markers(const Eigen::Matrix3Xd& rest_m, const Eigen::Matrix3Xd& seen_m, double tolerance_m,
                                  const Eigen::Matrix3d& expected = Eigen::Matrix3d::Identity());

}  // namespace myo::measurement
