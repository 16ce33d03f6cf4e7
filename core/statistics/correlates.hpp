#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::statistics {

/// A course over time that an unexplained force may follow: position, velocity, |v| v, strain rate, actuation, time.
struct Regressor {
    std::string name;
    Eigen::VectorXd values;  // T, NaN where not known
};

struct Correlate {
    std::string name;
    double correlation = 0.0;        // plain coefficient, -1 ... 1, of the samples that both know
    double effective_samples = 0.0;  // samples over Bartlett's variance inflation
    double p = 1.0;                  // Student's t with so many samples; not corrected for the number of regressors
};

/// Correlation of an amplitude a(t) with each regressor, strongest first. A course that does not change correlates with
/// nothing.
/// @param amplitude  T evenly spaced samples, NaN where not known
std::vector<Correlate> correlates(const Eigen::VectorXd& amplitude, const std::vector<Regressor>& regressors);

}  // namespace myo::statistics
