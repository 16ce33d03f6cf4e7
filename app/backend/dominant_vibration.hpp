#pragma once

#include <limits>

#include "setup/setup.hpp"

namespace myo::backend {

/// Vibration of a measured coordinate about its rest value.
struct MeasuredVibration {
    double energy_m2 = 0.0;     // sum of squares of the analysed samples
    double frequency_Hz = 0.0;  // of the fit, else from zero crossings; 0 without crossings
    double damping_ratio = std::numeric_limits<double>::quiet_NaN();  // of the fitted free vibration; NaN if none fits
};

/// Analyses one coordinate; its rest value is the mean of what is seen in the last fifth of the samples. Zero crossings
/// give the frequency; a damped cosine replaces it, and gives the damping, where it describes the samples.
///
/// @param times_s  ascending, equidistant
/// @param values   [m], one per time, at least one; NaN = occluded
/// @return         frequency 0 with fewer than three crossings, or if the whole last fifth is occluded
MeasuredVibration vibration_of(const Eigen::VectorXd& times_s, const Eigen::VectorXd& values);

/// The vibration with the largest energy of all markers, coordinates and trials, from the start of each trial on;
/// frequency 0 if no coordinate vibrates.
MeasuredVibration dominant_vibration(const setup::Setup& setup);

}  // namespace myo::backend
