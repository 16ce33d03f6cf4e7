#pragma once

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

/// Options of find_motion_start().
struct MotionStartOptions {
    double reference_lag_s = 0.08;  // a sample is compared with the median position of its marker this long before ...
    double reference_length_s = 0.16;  // ... over this length; at least 8 and 16 samples
    double mover_fraction = 0.2;       // markers whose peak is below this fraction of the largest peak are ignored
    double gross_fraction = 0.1;       // fraction of the largest departure that is certainly motion
    int sustained_samples = 3;         // consecutive samples above the limit
    double noise_factor = 5.0;         // threshold in standard deviations of the noise
};

/// Start of the motion of a body that was held still before.
struct StartOfMotion {
    bool found = false;
    double time_s = 0.0;              // estimate between samples, on the time axis of the recording
    Eigen::Index first_moving = 0;    // first sample above the threshold
    Eigen::Index last_still = -1;     // first_moving - 1; -1: none
    double threshold_m = 0.0;         // departure that counts as motion
    double noise_m = 0.0;             // standard deviation per coordinate, over the moving markers
    std::vector<std::string> movers;  // labels of the markers used
    std::string message;              // one sentence for the user
};

/// Finds the start of the first large motion.
///
/// The departure of a marker is its distance from its recent position, so that slow drift does not count. The departure
/// of the group is the median over the moving markers, so that a jump of one marker does not count. From the first
/// certain motion the search goes back to the last sample within the noise. The time between samples is extrapolated
/// from the first displacements, which grow as t^2, or as t for slow drives.
///
/// @param labels  markers to use; empty: all. Fixed markers may be among them
/// Errors: found = false with a message if nothing moves, if the motion has begun by the second sample (time_s is then
/// that of the first sample), or if a label is unknown.
StartOfMotion find_motion_start(const Recording& recording, const std::vector<std::string>& labels = {},
                                const MotionStartOptions& options = {});

}  // namespace myo::measurement
