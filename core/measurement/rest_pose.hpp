#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

struct RestPoseOptions {
    double longest_s = 1.0;           // only this much before the start: a hand-held body drifts
    double outlier_deviations = 4.0;  // samples farther from the median (in robust standard deviations) are left out
};

/// Where the markers were before the motion.
struct RestPose {
    std::vector<std::string> labels;
    Eigen::Matrix3Xd positions_m;  // 3 x labels, mean of the samples used; NaN for a marker never seen before the start
    Eigen::VectorXd deviation_m;   // labels, standard deviation per coordinate of the samples used
    Eigen::VectorXi samples_used;  // labels
    std::vector<std::string> missing;  // labels never seen before the start
};

/// Mean of each marker over the samples before the start.
///
/// A start-up transient of a marker does not bias it: samples far from the median of their coordinate are left out.
/// @param start_sample  number of still samples at the front of the recording
/// Error: start_sample < 1, or no marker is seen before the start.
Result<RestPose> rest_pose(const Recording& recording, Eigen::Index start_sample, const RestPoseOptions& options = {});

/// The same with the samples earlier than `start_s`; when the recording begins at the start, its first sample is taken.
Result<RestPose> rest_pose_before(const Recording& recording, double start_s, const RestPoseOptions& options = {});

}  // namespace myo::measurement
