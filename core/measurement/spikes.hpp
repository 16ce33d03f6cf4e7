#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::measurement {

/// Samples of a track that no motion explains.
struct Spikes {
    std::vector<Eigen::Index> samples;  // ascending
    double largest_m = 0.0;             // farthest that one stands out
};

/// Runs of one to three samples that stand out from a cubic through their neighbours in time, as a reflection or
/// another marker taken for this one makes them: by ten deviations of the noise and six times as far as any sample
/// nearby does without them. What stays where it jumped to (a marker that slips), and a bend of the motion (a body let
/// go), which the neighbours show, too, are none. Hampel's idea (1974) with a motion in the median's place.
///
/// @param track   3 x T [m], NaN where occluded
/// @param time_s  T, ascending
/// @param sigma_m deviation of the noise per coordinate; 0 where it is not known
Spikes find_spikes(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s, double sigma_m);

}  // namespace myo::measurement
