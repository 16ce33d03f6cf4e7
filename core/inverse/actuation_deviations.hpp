#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "inverse/actuation_fit.hpp"

namespace myo::inverse {

/// How well a target determines the values of the signals that follow it, signals x knots.
struct ActuationDeviations {
    bool found = false;
    std::string reason;  // why not, a sentence's end
    /// Standard deviations; NaN where less than half of what is known of a value comes from the target. They hold the
    /// noise and what the smoothness may hide of a signal whose rate is nowhere larger than it is where it was seen.
    Eigen::MatrixXd deviations;
    /// The share of what is known of a value that comes from the target, 0 ... 1; the rest is the smoothness (diagonal
    /// of the resolution matrix, Menke 2018, ch. 4).
    Eigen::MatrixXd from_target;
    Eigen::MatrixXd correlation;  // of all values, signals running fastest
    double noise_m = 0.0;         // of a coordinate: the given one, or what is left of the residuals where that is more
    double seconds = 0.0;
    std::vector<std::string> warnings;  // values and signals that are not told apart
};

/// More values than these are not worth their tangents: each costs about as much as an eighth of a run.
inline constexpr Eigen::Index most_deviations = 200;

/// Standard deviations at the end of a fit, from the Gauss-Newton Hessian of the loss: the residuals' exact derivatives
/// with respect to every value (one run with tangents), and the smoothness, which is no knowledge but shifts the
/// values. Values at a bound count as if it were not there.
///
/// @param noise_m  of a coordinate of the target, one standard deviation
/// Not found: too many values, or the run was stopped or failed; the reason says which.
ActuationDeviations actuation_deviations(const ActuationProblem& problem, const Eigen::MatrixXd& values, double noise_m,
                                         const Progress& progress = {});

}  // namespace myo::inverse
