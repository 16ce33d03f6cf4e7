#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::measurement {

/// Samples at exactly 0, 0, 0 that are gaps: several programs write zeros where a marker is hidden.
///
/// A measured position is exactly zero in three coordinates only if the marker passes the origin; then its other
/// samples come nearer to the origin than the track moves between two samples. A track of zeros alone is kept: the
/// marker may be the origin.
///
/// @param track  3 x T [m], NaN where occluded
/// @return       ascending
std::vector<Eigen::Index> find_zero_gaps(const Eigen::Matrix3Xd& track);

}  // namespace myo::measurement
