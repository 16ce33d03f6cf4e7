#pragma once

#include <Eigen/Core>

namespace myo::measurement {

/// Median; the mean of the two middle values for an even count. Asserts at least one value; none may be NaN.
double median(Eigen::VectorXd values);

/// Median absolute deviation from `centre`, scaled to the standard deviation of a normal distribution (factor 1.4826).
double median_deviation(const Eigen::VectorXd& values, double centre);

}  // namespace myo::measurement
