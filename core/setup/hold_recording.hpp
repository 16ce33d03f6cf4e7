#pragma once

#include <Eigen/Core>

#include "measurement/recording.hpp"

namespace myo::setup {

/// The pose of a body at rest from its recording: the mean of each marker's samples, as one sample at t = 0.
///
/// All samples of a hold measure one pose. As separate residuals they would repeat the same deviation of the model, and
/// standard deviations would fall with their number. Markers that no sample shows are NaN; residuals are dropped.
measurement::Recording mean_pose(const measurement::Recording& recording);

/// How far the samples of a hold lie from their mean: root mean square per marker and coordinate [m]; NaN for markers
/// with fewer than two samples. Slow drift within a hold is most of it, which no mean removes.
Eigen::VectorXd spread_of_pose(const measurement::Recording& recording);

}  // namespace myo::setup
