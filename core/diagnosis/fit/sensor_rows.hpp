#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::diagnosis {

// Readings of sensors in the fits of a diagnosis: S entries in the order trial, series, reading, in units of what
// they may be off by. Predictions are not corrected for the error of mesh and step, as those of markers are, so that a
// share of each reading is allowed for besides the noise.

/// Prediction minus reading over what the reading may be off by, S; 0 where nothing is compared.
///
/// @param trials       indices of the setup's trials
/// @param predictions  one per entry of `trials`
Eigen::VectorXd sensor_rows(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                            const std::vector<prediction::TrialPrediction>& predictions,
                            const DeclaredFitPolicy& policy);

/// Derivative of sensor_rows() with respect to parameter `number` of the tangents of the predictions.
Eigen::VectorXd sensor_slope(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                             const std::vector<prediction::TrialPrediction>& predictions, std::size_t number,
                             const DeclaredFitPolicy& policy);

}  // namespace myo::diagnosis
