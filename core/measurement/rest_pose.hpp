#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Options of rest_pose().
struct RestPoseOptions {
    double
        longest_s = 1.0;  // length of the averaging interval before the start; short, because a hand-held body drifts
    double outlier_deviations = 4.0;  // samples farther from the median (in robust standard deviations) are discarded
};

/// Marker positions before the motion.
struct RestPose {
    std::vector<std::string> labels;
    Eigen::Matrix3Xd positions_m;      // 3 x labels, mean of the samples used; NaN: never visible before the start
    Eigen::VectorXd deviation_m;       // per label, standard deviation per coordinate of the samples used
    Eigen::VectorXi samples_used;      // per label
    std::vector<std::string> missing;  // labels never visible before the start
};

/// Mean position of each marker over the samples before the start.
///
/// Samples far from the median of their coordinate are discarded, so that a transient at the beginning of the recording
/// does not bias the mean. If a marker was hidden in the last `longest_s`, earlier samples are used.
/// @param start_sample  number of still samples at the beginning of the recording
/// Errors: start_sample < 1; no marker is visible before the start.
Result<RestPose> rest_pose(const Recording& recording, Eigen::Index start_sample, const RestPoseOptions& options = {});

/// As rest_pose(), with the samples before time `start_s`; at least the first sample is used.
Result<RestPose> rest_pose_before(const Recording& recording, double start_s, const RestPoseOptions& options = {});

}  // namespace myo::measurement
