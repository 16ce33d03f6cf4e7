#pragma once

#include <Eigen/Core>

#include "base/result.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// Which of the places that cameras saw is which marker of a body.
struct MarkerMatch {
    Eigen::VectorXi seen;  // per marker of the body: column of the seen places, -1 = none
    RigidMotion motion;    // cameras -> body
    double rms_m = 0.0;    // of the distances of the matched
    bool unique = true;    // no other match explains as many markers as well: the arrangement is not symmetric

    int count() const { return static_cast<int>((seen.array() >= 0).count()); }
};

/// The rigid motion that brings most of the seen places onto markers at rest, and among motions that do so equally well
/// the one nearest to the expected rotation.
///
/// Triples of markers with long sides are looked for among the seen places by the lengths of their sides; each hit
/// gives a motion, under which the others are told by their nearest place. Where markers stand on one line, or fewer
/// than three fit, only the expected rotation is tried.
/// @param rest_m       3 x n [m], body frame
/// @param seen_m       3 x m [m], camera frame; NaN = never seen
/// @param tolerance_m  largest distance of a marker from its place
/// @param expected     rotation, cameras -> body
/// Error: no marker, or no place.
Result<MarkerMatch> match_markers(const Eigen::Matrix3Xd& rest_m, const Eigen::Matrix3Xd& seen_m, double tolerance_m,
                                  const Eigen::Matrix3d& expected = Eigen::Matrix3d::Identity());

}  // namespace myo::measurement
