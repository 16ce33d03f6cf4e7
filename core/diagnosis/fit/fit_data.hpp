#pragma once

#include <Eigen/Core>

#include <vector>

#include "inverse/marginal_nuisance.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"
#include "statistics/residual_layout.hpp"

namespace myo::diagnosis {

/// Correction that is added to predictions to remove the error of mesh and time step: [trial of the setup][marker], 3 x
/// T [m].
using PredictionShift = std::vector<std::vector<Eigen::Matrix3Xd>>;

/// Samples on which trials are compared, flattened to N entries in the order trial, marker, axis (x, y, z), time.
struct FitData {
    std::vector<std::size_t> trials;    // indices of the setup's trials
    statistics::ResidualLayout layout;  // its trial numbers are these indices
    Eigen::VectorXd noise_m;            // N: standard deviation of the noise per entry
    bool noise_declared = true;         // false: noise of still markers, below what a model of a real body can reach
    PredictionShift shift;              // empty: no correction
    double floor_m = 0.0;               // what repeated trials leave, see Repeatability; 0: none was repeated
    /// Unknown places of the markers over markers.placement_m, three per marker, see with_unknown_places(). If not
    /// empty, all flat vectors and matrices are whitened by them: residuals of the right model are noise of variance 1.
    inverse::MarginalNuisance places = {};
    double placement_m = 0.0;  // markers.placement_m, if there are unknown places
};
/// Measured samples of these trials, from the first sample of each that is compared.
/// Gaps (samples that are not finite) are left out per marker. A marker without samples has no series.
FitData fit_data(const setup::Setup& setup, const std::vector<std::size_t>& trials);

/// The data with the places of the markers as unknowns, linearised at these predictions. Unchanged if
/// markers.placement_m is 0.
FitData with_unknown_places(const setup::Setup& setup, FitData data,
                            const std::vector<prediction::TrialPrediction>& predictions);

/// Most probable places of the markers [m] for a flat residual; empty if they are exact.
std::vector<Eigen::Vector3d> probable_places(const setup::Setup& setup, const FitData& data,
                                             const Eigen::VectorXd& residual);

/// Residual (prediction + shift - measurement) / noise, N; predictions in the order of data.trials.
Eigen::VectorXd flat_residual(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions);

/// Shift / noise, N; 0 where the shift is empty.
Eigen::VectorXd flat_shift(const FitData& data, const PredictionShift& shift);

/// Jacobian of flat_residual() from the tangents of the predictions, N x parameters.
/// @param predictions  with `parameters` tangents each, in the order of data.trials; all must have succeeded
Eigen::MatrixXd flat_jacobian(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions,
                              std::size_t parameters);

/// Derivatives of residuals with respect to one parameter: [trial of data.trials][marker], 3 x samples [m per unit].
using TrialTangents = std::vector<std::vector<Eigen::Matrix3Xd>>;

/// One column of the Jacobian: tangents / noise, N.
Eigen::VectorXd flat_tangent(const FitData& data, const TrialTangents& tangents);

/// Root mean square of the noise over all entries [m]; 0 without entries.
double mean_noise_m(const FitData& data);

/// Root mean square of a flat residual [m].
/// Entries are weighted by their noise, which the residual was divided by; 0 without entries.
double flat_rms_m(const FitData& data, const Eigen::VectorXd& residual);

/// Trial (index in the setup) with the largest mean square of a flat residual.
std::size_t worst_trial(const FitData& data, const Eigen::VectorXd& residual);

/// Prediction with the shift of its trial added to residual and positions. Unchanged if the prediction failed or the
/// trial has no shift.
prediction::TrialPrediction shifted(prediction::TrialPrediction prediction, const PredictionShift& shift,
                                    std::size_t trial);

}  // namespace myo::diagnosis
