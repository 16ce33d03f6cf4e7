#pragma once

#include <limits>

#include "setup/setup.hpp"

namespace myo::backend {

/// A measured coordinate's motion about where it comes to rest.
struct MeasuredVibration {
    double energy_m2 = 0.0;     // sum of squares of what was looked at
    double frequency_Hz = 0.0;  // of the fit, else from zero crossings; 0 when it does not cross
    double damping_ratio = std::numeric_limits<double>::quiet_NaN();  // of the free vibration fitted to it; NaN when
                                                                      // none fits
};

/// Of one coordinate; it is at rest at its mean over the last fifth of the samples.
///
/// @param times_s  ascending, at equal distances
/// @param values   [m], NaN = occluded
MeasuredVibration vibration_of(const Eigen::VectorXd& times_s, const Eigen::VectorXd& values);

/// The largest of all markers and coordinates of all trials.
MeasuredVibration dominant_vibration(const setup::Setup& setup);

}  // namespace myo::backend
