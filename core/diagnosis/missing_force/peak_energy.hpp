#pragma once

#include <vector>

#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// Largest isochoric energy density mu/2 (I1 - 3) of any cell in motions of these models [J/m3], with the mean
/// deformation of the cell. predictions: with their traces, one per model; of every tenth step.
double peak_isochoric_energy(const std::vector<model::Model>& models,
                             const std::vector<prediction::TrialPrediction>& predictions);

}  // namespace myo::diagnosis
