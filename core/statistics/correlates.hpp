#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::statistics {

/// Time course that an unexplained force may follow: position, velocity, |v| v, strain rate, actuation or time.
struct Regressor {  // shown in reports
    std::string name;
    Eigen::VectorXd values;  // T samples, NaN if unknown; any unit
};

/// Correlation of an amplitude with one regressor.
struct Correlate {
    std::string name;                // of the regressor
    double correlation = 0.0;        // Pearson coefficient over the samples known to both, -1 ... 1
    double effective_samples = 0.0;  // samples divided by Bartlett's variance inflation
    double p = 1.0;  // two-sided, Student's t with effective_samples - 2; not corrected for the number of regressors
};

/// Correlation of an amplitude a(t) with each regressor, sorted by decreasing |correlation|. A constant regressor gives
/// 0.
///
/// @param amplitude   T evenly spaced samples, NaN if unknown
/// @param regressors  T samples each, on the same times
std::vector<Correlate> correlates(const Eigen::VectorXd& amplitude, const std::vector<Regressor>& regressors);

}  // namespace myo::statistics
