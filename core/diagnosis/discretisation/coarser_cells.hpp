#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/progress.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// The setup on coarser cells. A diagnosis may use coarser cells than a single run, because their error is removed, see
/// numerical_error() and NumericsPolicy.
struct CoarserCells {
    std::shared_ptr<const setup::Setup> setup;  // with steps and trials of the given one; null: no coarser cells serve
    double change_m = 0.0;  // of a trial at most, apart from what another modulus makes up for [m, rms]
    int runs = 0;           // trial runs
};

/// The coarsest cells of NumericsPolicy::cell_ratios for which the prediction of no trial changes by more than max_m
/// [m, rms], apart from what another modulus of the cells makes up for. Hexahedra only: between meshes of tetrahedra,
/// which are not similar to each other, the error follows no order (example_actuation_lag then got a second effect).
/// Edges that the user states are kept.
///
/// @param trials     that are compared
/// @param reference  predictions of these trials with `values` on the given cells
CoarserCells coarser_cells(const setup::Setup& setup, const prediction::ParameterValues& values,
                           const std::vector<std::size_t>& trials,
                           const std::vector<prediction::TrialPrediction>& reference, double max_m,
                           const NumericsPolicy& policy, const Progress& progress);

}  // namespace myo::diagnosis
