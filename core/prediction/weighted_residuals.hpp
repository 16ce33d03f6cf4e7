#pragma once

#include <cstddef>
#include <vector>

#include "inverse/least_squares.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Residuals and Jacobian of several trials in units of the noise, for a Gauss-Newton fit.
///
/// @param predictions  one per entry of `trials`, each with at least `parameters` tangents
/// @return             3 x markers x samples rows per trial, then one per reading of a sensor; occluded coordinates and
///                     readings outside the run have residual and derivative 0
/// Errors: none; not ok, with the reason, if a trial could not be run.
inverse::ResidualEvaluation weighted_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                               const std::vector<TrialPrediction>& predictions, std::size_t parameters);

}  // namespace myo::prediction
