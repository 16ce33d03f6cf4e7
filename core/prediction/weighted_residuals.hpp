#pragma once

#include <cstddef>
#include <vector>

#include "inverse/least_squares.hpp"
#include "inverse/marginal_nuisance.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Residuals and Jacobian of several trials in units of the noise, for a Gauss-Newton fit.
///
/// With markers.placement_m, the unknown places of the markers are marginalised out of both, see MarginalNuisance. The
/// residuals are those at the declared places, whatever the places of the predictions. The Jacobian is exact if these
/// are the most probable ones.
/// @param predictions  one per entry of `trials`, each with at least `parameters` tangents
/// @return             3 x markers x samples rows per trial, then one per reading of a sensor; occluded coordinates and
///                     readings outside the run have residual and derivative 0
/// Errors: none; not ok, with the reason, if a trial could not be run.
inverse::ResidualEvaluation weighted_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                               const std::vector<TrialPrediction>& predictions, std::size_t parameters);

/// Unknown places of the markers over markers.placement_m as a nuisance of these residuals, three per marker. Empty if
/// the places are exact or a trial could not be run.
inverse::MarginalNuisance unknown_places(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                         const std::vector<TrialPrediction>& predictions);

/// The predictions of runs, observed with the markers at their most probable places for these runs; as they are if the
/// places are exact or a trial could not be run.
///
/// @param values       with which they were made; receive the places
/// @param predictions  one per entry of `trials`, with traces
std::vector<TrialPrediction> at_probable_places(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                                ParameterValues& values, std::vector<TrialPrediction> predictions);

}  // namespace myo::prediction
