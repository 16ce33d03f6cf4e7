#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

// The noise of a recording is estimated from the recording itself; no separate trial at rest is needed. It sets the
// thresholds for spikes, excursions and the start of the motion.

/// Measurement noise of one marker.
struct NoiseEstimate {
    std::string label;
    bool found = false;              // false: too few consecutive samples, see estimate_noise()
    double sigma_m = 0.0;            // standard deviation per coordinate, rounding of the file included
    double quantum_m = 0.0;          // smallest difference of values in the file; 0 if all are equal
    Eigen::Index still_samples = 0;  // number of samples in still windows
};

/// White noise of each marker, estimated from the stillest parts of its track.
///
/// Sixth differences of the samples, divided by sqrt(924), have the variance of white noise and suppress motion well
/// below a sixth of the frame rate. Their mean square is taken in short windows. Windows above the range of chance
/// count as moving and are excluded; the limit follows the estimate until both are consistent. Samples that repeat
/// their predecessor (polled streams) are removed first; gaps split the track.
///
/// Bias: too high if less than about a tenth of the recording is still, or if vibration above a sixth of the frame rate
/// never ceases. Too low if the recording was smoothed, or if the noise is slow drift, which only repeated trials
/// reveal. Never below quantum / sqrt(12), the rounding error of the file. Needs 12 consecutive samples without a gap.
std::vector<NoiseEstimate> estimate_noise(const Recording& recording);

/// Noise of a single track, 3 x T [m], NaN where occluded; the label stays empty.
NoiseEstimate estimate_track_noise(const Eigen::Matrix3Xd& track);

/// Rounding unit of the numbers in a file [m]: the largest of 1, 2 or 5 times a power of ten, from 5 mm to 1 um, of
/// which all coordinates are multiples. 0 if there is none, or if coordinates change fewer than twenty times.
double rounding_step(const std::vector<Eigen::Matrix3Xd>& tracks);

/// Standard deviation of the error of rounding to multiples of `step`, step / sqrt(12).
double rounding_deviation(double step);

/// Root mean square of the noise over the markers with an estimate; 0 if there are none.
double mean_noise(const std::vector<NoiseEstimate>& estimates);

}  // namespace myo::measurement
