#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

/// An interval beside a gap in which a track followed something other than its marker.
struct FalseStretch {
    std::size_t marker = 0;           // index of the track
    Eigen::Index first = 0, end = 0;  // samples [first, end)
    double offset_m = 0.0;            // largest distance from the expected position
};

/// Finds false stretches that begin or end at a gap of any length. Stretches between two visible jumps are found by
/// find_excursions().
///
/// A position is predicted from the other markers, see MarkerPredictor. Candidates lie between two breaks of the track,
/// where the residual of a first prediction jumps; at least one of the two breaks is a gap.
/// In a false stretch every sample is farther from the prediction than 1 mm, 20 standard deviations of the noise and
/// six times the distance of the fitted samples, widened by the leverage of extrapolation and by what the principal
/// motions leave unexplained in the other markers. The samples on both sides of the stretch are within half of that: a
/// marker that slipped does not return. At most half of a track is false.
///
/// @param tracks   one per marker, 3 x T [m], NaN where occluded; at least two others must be visible
/// @param sigma_m  per marker, standard deviation of the noise per coordinate; 0 if unknown
/// @return         in order of time
std::vector<FalseStretch> find_false_stretches(const std::vector<Eigen::Matrix3Xd>& tracks,
                                               const Eigen::VectorXd& sigma_m);

}  // namespace myo::measurement
