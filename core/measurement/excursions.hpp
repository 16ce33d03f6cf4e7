#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

/// A marker that was taken for something else for a while.
struct Excursion {
    std::size_t marker = 0;
    Eigen::Index first = 0, end = 0;  // samples [first, end) of its track
    double jump_m = 0.0;              // the larger of the two, away and back
};

/// Tracks that jump away within a sample and back later, four samples or more between, half of the record at most:
/// reflections and unnamed markers that a camera system follows until it finds the right one again. (Shorter ones are
/// spikes; what stays away has slipped.)
///
/// A jump is what the mean velocity of both sides leaves of the way from one seen sample to the next. Of an excursion
/// both stand out: by twenty deviations of the noise, six times as far as the track departs from its velocity nearby,
/// and six times as far as any other marker does in that moment, of which two have to be seen: a body that is struck,
/// or that follows a load faster than it is filmed, moves more than one. They point against each other, and neither is
/// more than twice the other.
///
/// @param tracks  one for each marker, 3 x T [m], NaN where occluded
/// @param time_s  T, ascending
/// @param sigma_m of each marker, deviation of the noise per coordinate; 0 where it is not known
/// @return in the order of time
std::vector<Excursion> find_excursions(const std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& time_s,
                                       const Eigen::VectorXd& sigma_m);

}  // namespace myo::measurement
