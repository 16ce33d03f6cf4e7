#pragma once

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

struct MotionStartOptions {
    double reference_lag_s = 0.08;     // a sample is compared with the mean place of the marker this long before ...
    double reference_length_s = 0.16;  // ... over this length; both are at least 8 and 16 samples
    double mover_fraction = 0.2;       // markers that move less than this part of the one that moves most do not count
    double gross_fraction = 0.1;       // part of the largest departure that is motion without doubt
    int sustained_samples = 3;         // for so many samples in a row
    double noise_factor = 5.0;         // a departure of this many standard deviations of the noise is motion
};

/// Where a body that was held still begins to move.
struct StartOfMotion {
    bool found = false;
    double time_s = 0.0;              // estimate between samples; in the times of the recording
    Eigen::Index first_moving = 0;    // first sample that has left the rest
    Eigen::Index last_still = -1;     // first_moving - 1, -1 when there is no still sample
    double threshold_m = 0.0;         // departure that counted as motion
    double noise_m = 0.0;             // standard deviation per coordinate of the markers that move
    std::vector<std::string> movers;  // markers that decided
    std::string message;              // one sentence for a person
};

/// Finds the start of the first large motion.
///
/// The departure of a marker is its distance from where it was shortly before, so that slow drift does not count; that
/// of the group is the median over the markers that move, so that a jump of one marker does not. From the first
/// departure that is motion without doubt the search goes back to the last sample within the noise. The time between
/// the samples follows from the first displacements growing as t^2, or as t for slow drives.
/// @param labels  markers to look at; empty = all. Fixed markers may be among them
/// found = false, with a message: nothing moves; the motion has already begun in the first sample (time_s is then the
/// first sample's); no label is known. Never fails otherwise.
StartOfMotion find_motion_start(const Recording& recording, const std::vector<std::string>& labels = {},
                                const MotionStartOptions& options = {});

}  // namespace myo::measurement
