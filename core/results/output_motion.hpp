#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/recording.hpp"
#include "prediction/prediction.hpp"

namespace myo::results {

/// Markers of a trial in the compared form: positions in the camera frame, or displacements from the rest pose. Per
/// marker 3 x T [m] at time_s; measured is NaN where occluded, simulated has no gaps.
struct ComparedMotion {
    Eigen::VectorXd time_s;  // T sample times [s]; 0 is the start
    std::vector<Eigen::Matrix3Xd> measured_m;
    std::vector<Eigen::Matrix3Xd> simulated_m;
};

/// Measured and simulated markers of a trial in the compared form. Asserts that the trial completed.
ComparedMotion compared_motion(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                               const prediction::TrialPrediction& prediction);

/// Simulated markers at the measured sample times, mesh frame [m]. Asserts that the trial completed.
measurement::Recording simulated_recording(const setup::Setup& setup, std::size_t trial,
                                           const prediction::TrialPrediction& prediction);

/// Frequency of the largest vibration of a trial's simulated markers [Hz], after subtraction of the steady state; 0 if
/// nothing vibrates for at least one period.
/// Samples before the first compared one are left out. Resolved to a quarter of 1 / duration, up to the Nyquist
/// frequency or 50 Hz. Asserts that the trial completed.
double main_frequency(const setup::Setup& setup, std::size_t trial, const prediction::TrialPrediction& prediction);

}  // namespace myo::results
