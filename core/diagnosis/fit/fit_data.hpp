#pragma once

#include <Eigen/Core>

#include <vector>

#include "prediction/prediction.hpp"
#include "setup/setup.hpp"
#include "statistics/residual_layout.hpp"

namespace myo::diagnosis {

/// What is added to predictions of trials, so that they are those of a finer mesh and step: [trial of the
/// setup][marker] 3 x T [m].
using PredictionShift = std::vector<std::vector<Eigen::Matrix3Xd>>;

/// The samples on which trials are compared, flattened: trial by trial, marker by marker, x y z, in time order.
struct FitData {
    std::vector<std::size_t> trials;    // of the setup
    statistics::ResidualLayout layout;  // its trials are those numbers
    Eigen::VectorXd noise_m;            // per entry
    bool noise_declared = true;  // by the experiment; otherwise it is that of still markers, which no model of a real
                                 // body comes down to
    PredictionShift shift;       // empty: none
};
FitData fit_data(const setup::Setup& setup, const std::vector<std::size_t>& trials);

/// (prediction + shift - measurement) / noise of the trials' predictions, in the order of data.trials.
Eigen::VectorXd flat_residual(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions);

/// A shift / noise alone, 0 where it is empty.
Eigen::VectorXd flat_shift(const FitData& data, const PredictionShift& shift);

/// Derivatives of the same, N x parameters.
Eigen::MatrixXd flat_jacobian(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions,
                              std::size_t parameters);

/// Derivatives of residuals by one number: [trial of data.trials][marker], 3 x samples [m per unit].
using TrialTangents = std::vector<std::vector<Eigen::Matrix3Xd>>;

/// One derivative of the same.
Eigen::VectorXd flat_tangent(const FitData& data, const TrialTangents& tangents);

/// Root mean square of a flat residual [m].
double flat_rms_m(const FitData& data, const Eigen::VectorXd& residual);

/// The trial with the largest mean square of a flat residual.
std::size_t worst_trial(const FitData& data, const Eigen::VectorXd& residual);

/// A prediction with the shift of its trial added to its residual and positions.
prediction::TrialPrediction shifted(prediction::TrialPrediction prediction, const PredictionShift& shift,
                                    std::size_t trial);

}  // namespace myo::diagnosis
