#pragma once

#include <Eigen/Core>

#include <cmath>

namespace myo::inverse {

/// Free vibration y = offset + exp(-rate t) (a cos omega t + b sin omega t).
struct DampedCosine {
    bool ok = false;
    double rate_1_s = 0.0;
    double omega_rad_s = 0.0;
    double offset = 0.0;
    double amplitude = 0.0;  // sqrt(a² + b²), at t = 0
    double rms = 0.0;        // of the residuals

    /// Fraction of critical damping, rate / |exponent|.
    double damping_ratio() const { return rate_1_s / std::hypot(rate_1_s, omega_rad_s); }
};

/// Least-squares fit to equally spaced samples, started from the two-term recurrence that such samples satisfy.
///
/// @param times_s  ascending, n >= 8 (asserted), at least four samples per period
/// Errors: ok = false if the samples do not oscillate.
DampedCosine fit_damped_cosine(const Eigen::VectorXd& times_s, const Eigen::VectorXd& values);

}  // namespace myo::inverse
