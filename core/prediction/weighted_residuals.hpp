#pragma once

#include <cstddef>
#include <vector>

#include "inverse/least_squares.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Residuals and Jacobian of some trials in units of the noise; occluded coordinates have residual 0. Not ok where a
/// trial could not be run, with the reason.
///
/// @param predictions  of the trials, in their order, with at least so many tangents as there are parameters
inverse::ResidualEvaluation weighted_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                               const std::vector<TrialPrediction>& predictions, std::size_t parameters);

}  // namespace myo::prediction
