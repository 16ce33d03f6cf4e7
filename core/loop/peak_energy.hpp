#pragma once

#include <vector>

#include "project/prediction.hpp"

namespace myo {

/// Largest isochoric energy density mu/2 (I1 - 3) of any cell in motions of these models [J/m3], with the mean deformation of the cell.
/// predictions: with their traces, one per model; of every tenth step.
double peak_isochoric_energy(const std::vector<Model>& models, const std::vector<TrialPrediction>& predictions);

}  // namespace myo
