#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

/// An interval in which a track followed something other than its marker.
struct Excursion {
    std::size_t marker = 0;           // index of the track
    Eigen::Index first = 0, end = 0;  // samples [first, end)
    double jump_m = 0.0;              // the larger of the jumps away and back
};

/// Finds excursions: the track jumps away within one sample and jumps back later.
///
/// The cause is a reflection or an unlabelled marker that the camera system follows until it recovers the right one. An
/// excursion lasts at least four samples and at most half of the recording. Shorter ones are spikes; a marker that does
/// not return has slipped.
///
/// The jump of a sample interval is its displacement minus that of the mean velocity of both neighbouring intervals.
/// Both jumps of an excursion must exceed 20 standard deviations of the noise, six times the largest jump nearby in the
/// same track, and six times the jump of every other marker at that time, of which at least two must be visible: a body
/// that is struck, or follows a load faster than the frame rate, moves several markers. The two jumps have opposite
/// directions, and their ratio is at most two.
///
/// @param tracks   one per marker, 3 x T [m], NaN where occluded
/// @param time_s   T, ascending
/// @param sigma_m  per marker, standard deviation of the noise per coordinate; 0 if unknown
/// @return         in order of time
std::vector<Excursion> find_excursions(const std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& time_s,
                                       const Eigen::VectorXd& sigma_m);

}  // namespace myo::measurement
