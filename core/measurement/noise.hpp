#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

/// Measurement noise of one marker.
struct NoiseEstimate {
    std::string label;
    bool found = false;              // false: too few samples in a row (see estimate_noise)
    double sigma_m = 0.0;            // standard deviation per coordinate, rounding of the file included
    double quantum_m = 0.0;          // smallest step between values in the file, 0 when all values are equal
    Eigen::Index still_samples = 0;  // samples in windows that count as still
};

/// White noise of each marker, from the stillest stretches of its track.
///
/// Sixth differences of the samples, divided by sqrt(924), have the variance of white noise and all but cancel motion
/// well below a sixth of the frame rate. Their mean square is taken in short windows; windows that are too large to be
/// chance are left out as moving, and the threshold follows the estimate until it settles. Samples that repeat their
/// predecessor (polled streams) are taken out first; gaps split the track.
///
/// Too high: when less than about a tenth of the record is still, or vibration above a sixth of the frame rate never
/// stops. Too low: when the recording was smoothed, or its noise is slow wander, which only repeated trials can show.
/// Never below quantum / sqrt(12), the rounding error of the file.
/// Needs 12 samples in a row without a gap.
std::vector<NoiseEstimate> estimate_noise(const Recording& recording);

/// The same for a single track, 3 x T [m], NaN where occluded.
NoiseEstimate estimate_track_noise(const Eigen::Matrix3Xd& track);

/// The step that a file's numbers are rounded to [m]: the largest of 1, 2 or 5 times a power of ten, from 5 mm down to
/// 1 um, of which all coordinates are multiples. 0 where there is none, and where coordinates change fewer than twenty
/// times.
double rounding_step(const std::vector<Eigen::Matrix3Xd>& tracks);

/// Deviation of what rounding to a step does to a coordinate.
double rounding_deviation(double step);

/// Root mean square of the noise over the markers where it was found; 0 when it was found for none.
double mean_noise(const std::vector<NoiseEstimate>& estimates);

}  // namespace myo::measurement
