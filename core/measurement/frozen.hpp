#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

/// An interval in which a track repeats its position exactly while the body moves.
struct FrozenInterval {
    std::size_t marker = 0;           // index of the track
    Eigen::Index first = 0, end = 0;  // samples [first, end) that repeat the one before `first`
};

/// Finds intervals in which a system that lost a marker goes on to write its last position.
///
/// At least four samples in a row equal the one before them in all digits, while at least half of the other visible
/// markers move by more than ten times their noise and rounding. The marker is expected to move in proportion, by what
/// its other samples show, and by more than ten times the rounding. At rest a position repeats naturally if rounding
/// hides the noise; the interval must then end with a jump. Streams that repeat all markers at once are no fault of one
/// marker.
///
/// @param tracks      one per marker, 3 x T [m], NaN where occluded
/// @param rounding_m  increment of the numbers in the file; 0 if unknown
/// @return            ordered by marker, then by time
std::vector<FrozenInterval> find_frozen(const std::vector<Eigen::Matrix3Xd>& tracks, double rounding_m);

}  // namespace myo::measurement
