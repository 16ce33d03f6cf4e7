#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/recording.hpp"
#include "prediction/prediction.hpp"

namespace myo::results {

/// A trial's markers as they are compared: positions in the camera's frame, or displacements from the rest pose. Per
/// marker 3 x T [m] at time_s; measured is NaN where occluded, simulated has no gaps.
struct ComparedMotion {
    Eigen::VectorXd time_s;  // T; 0 is the start
    std::vector<Eigen::Matrix3Xd> measured_m;
    std::vector<Eigen::Matrix3Xd> simulated_m;
};

/// Asserts that the trial completed.
ComparedMotion compared_motion(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                               const prediction::TrialPrediction& prediction);

/// The simulated markers at the measured sample times, mesh frame. Asserts that the trial completed.
measurement::Recording simulated_recording(const setup::Setup& setup, std::size_t trial,
                                           const prediction::TrialPrediction& prediction);

/// Frequency of the largest vibration in a trial's simulated markers [Hz], rest and steady state taken out; 0 when
/// nothing vibrates for at least one period.
double main_frequency(const setup::Setup& setup, std::size_t trial, const prediction::TrialPrediction& prediction);

}  // namespace myo::results
