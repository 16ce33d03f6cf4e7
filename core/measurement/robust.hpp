#pragma once

#include <Eigen/Core>

namespace myo::measurement {

/// Middle value; the mean of the two middle ones for an even count. Needs at least one value, none NaN.
double median(Eigen::VectorXd values);

/// Median distance from `centre`, scaled to the standard deviation of a normal distribution (factor 1.4826).
double median_deviation(const Eigen::VectorXd& values, double centre);

}  // namespace myo::measurement
