#pragma once

#include <Eigen/Core>

#include <vector>

#include "setup/setup.hpp"

namespace myo::check {

/// Oscillation visible in a recording.
struct RecordedSwing {
    int turns = 0;              // number of reversals; below 3: no oscillation
    double frequency_Hz = 0.0;  // from the median time between reversals
};

/// Times [s] of the extremes at which a coordinate [m] reverses by more than `min_m`; non-finite samples are skipped.
/// The first motion away from the start is no reversal.
std::vector<double> turning_times(const Eigen::VectorXd& time_s, const Eigen::VectorXd& x_m, double min_m);

/// Time [s] of the last change of a trial's loads and signals; 0 if nothing changes after the start. Changes below a
/// twentieth of a signal's range are ignored: logs are noisy.
double last_change_s(const model::Model& model);

/// Oscillation of the coordinate with the largest motion from a time on, if it exceeds noise and a share of the range.
///
/// @param from_s   trial time after which the body moves freely
/// @param noise_m  1 sigma per coordinate
RecordedSwing recorded_swing(const setup::PreparedTrial& trial, double from_s, double noise_m);

}  // namespace myo::check
