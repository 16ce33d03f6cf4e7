#pragma once

#include <vector>

#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// Largest isochoric energy density mu/2 (I1 - 3) over all cells and every tenth step [J/m3], from the mean deformation
/// gradient of each cell.
/// All models have the mesh of the first one. 0 without models.
/// @param predictions  one per model, with their traces
double peak_isochoric_energy(const std::vector<model::Model>& models,
                             const std::vector<prediction::TrialPrediction>& predictions);

}  // namespace myo::diagnosis
