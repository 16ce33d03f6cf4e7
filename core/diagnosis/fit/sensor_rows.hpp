#pragma once

#include <Eigen/Core>

#include <vector>

#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::diagnosis {

// Readings of sensors in the fits of a diagnosis: S entries in the order trial, series, reading, in units of their
// noise. Predictions are not corrected for the error of mesh and step, as those of markers are.

/// Prediction minus reading over the noise, S; 0 where nothing is compared.
///
/// @param trials       indices of the setup's trials
/// @param predictions  one per entry of `trials`
Eigen::VectorXd sensor_rows(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                            const std::vector<prediction::TrialPrediction>& predictions);

/// Derivative of sensor_rows() with respect to parameter `number` of the tangents of the predictions.
Eigen::VectorXd sensor_slope(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                             const std::vector<prediction::TrialPrediction>& predictions, std::size_t number);

}  // namespace myo::diagnosis
