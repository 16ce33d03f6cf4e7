#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "inverse/actuation_fit.hpp"

namespace myo::inverse {

/// Accuracy with which a target determines the values of the fitted signals. Matrices are signals x knots.
struct ActuationDeviations {
    bool found = false;
    std::string reason;  // reason if not found: the end of a sentence
    /// Standard deviations; NaN where less than half of the information about a value comes from the target. They
    /// combine the noise with the bias that smoothing may cause in a signal whose rate nowhere exceeds its largest
    /// observed rate.
    Eigen::MatrixXd deviations;
    /// Fraction of the information about a value that comes from the target, 0 ... 1; the rest is the smoothness
    /// (diagonal of the resolution matrix, Menke 2018, ch. 4).
    Eigen::MatrixXd from_target;
    Eigen::MatrixXd correlation;        // of all values; the signal index varies fastest
    double noise_m = 0.0;               // per coordinate: the given noise, or the residual standard deviation if larger
    double seconds = 0.0;               // computing time
    std::vector<std::string> warnings;  // values and signals that the markers do not separate
};

struct ActuationDeviationsPolicy {
    /// Largest number of values for which deviations are computed. A tangent costs about an eighth of a run.
    Eigen::Index max_deviations = 200;
    /// Relative eigenvalue below which a direction is not determined at all.
    double not_seen = 1e-12;
    /// Values with less information from the target are interpolated by the smoothness rather than measured.
    double measured_share = 0.5;
};
inline constexpr ActuationDeviationsPolicy actuation_deviations_policy;

/// Standard deviations at the end of a fit, from the Gauss-Newton Hessian of the loss.
///
/// The Hessian consists of the exact derivatives of the residuals with respect to every value (one run with tangents)
/// and of the smoothness term, which is not information but biases the values. Values at a bound are treated as if they
/// were not bounded.
///
/// @param values   fitted values, signals x knots
/// @param noise_m  standard deviation of a coordinate of the target
/// Errors: found = false with a reason: too many values, run cancelled or failed.
ActuationDeviations actuation_deviations(const ActuationProblem& problem, const Eigen::MatrixXd& values, double noise_m,
                                         const Progress& progress = {});

}  // namespace myo::inverse
