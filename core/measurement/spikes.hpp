#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::measurement {

/// Isolated outliers of a track.
struct Spikes {
    std::vector<Eigen::Index> samples;  // ascending
    double largest_m = 0.0;             // largest distance from the interpolated motion
};

/// Finds spikes: runs of one to three samples that deviate from a cubic through their neighbours in time.
///
/// The cause is a reflection, or another marker mistaken for this one. Every sample of the run must deviate by more
/// than ten standard deviations of the noise and six times as far as nearby samples do without the run. A marker that
/// stays where it jumped to (slip) and a kink of the motion (a released body), which the neighbours show as well, are
/// no spikes. This is the Hampel filter (1974) with a local motion in place of the median.
///
/// @param track    3 x T [m], NaN where occluded
/// @param time_s   T, ascending
/// @param sigma_m  standard deviation of the noise per coordinate; 0 if unknown
Spikes find_spikes(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s, double sigma_m);

}  // namespace myo::measurement
