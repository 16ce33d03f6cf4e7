#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Changes of a trial's residuals by effects that are added one at a time, to first order in the effect.
///
/// The models with and without an effect differ by forces and masses at the unchanged motion, and one tangent run gives
/// the answers of the body to all of these: each costs forces and a solve per stage, where a run of its own costs
/// stiffness and factor in each iteration.
/// @param trial       index into Setup::trials
/// @param values      without the effects
/// @param effects     each acts on the trial and moves the body
/// @param warm_start  path of the run with `values`; may be null
/// @return            per effect and marker, 3 x samples [m]; empty where only a run shows the effect: if it changes
///                    the unknowns or the kind of the start, or if the run failed or was cancelled
std::vector<std::optional<std::vector<Eigen::Matrix3Xd>>> first_order_changes(
    const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
    const std::vector<effect::EffectDeclaration>& effects, const Progress& progress = {},
    std::shared_ptr<const dynamics::StagePath> warm_start = {});

}  // namespace myo::prediction
