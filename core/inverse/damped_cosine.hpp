#pragma once

#include <Eigen/Core>

#include <cmath>

namespace myo::inverse {

/// A free vibration y = offset + exp(-rate t) (a cos omega t + b sin omega t).
struct DampedCosine {
    bool ok = false;
    double rate_1_s = 0.0;
    double omega_rad_s = 0.0;
    double offset = 0.0;
    double amplitude = 0.0;  // at t = 0
    double rms = 0.0;        // of what is left

    double damping_ratio() const { return rate_1_s / std::hypot(rate_1_s, omega_rad_s); }
};

/// Fits it to samples at equal distances by least squares, from the two-term recurrence that such samples obey.
///
/// @param times_s  ascending, n >= 8, at least four samples a period
/// Not ok where the samples do not swing.
DampedCosine fit_damped_cosine(const Eigen::VectorXd& times_s, const Eigen::VectorXd& values);

}  // namespace myo::inverse
