#pragma once

#include <optional>

#include "effect/effect.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::effect {

// Effects change models in arbitrary ways, so that their derivatives cannot be coded by hand for each of them.

/// Derivative of a model and its start along a number of an effect, by a central difference.
///
/// Exact where forces, masses and start are linear in the number; otherwise the error is of the order of width squared.
/// Positions of the start are differentiated, too, [m per unit of the number].
///
/// @param under, between, over  model with the number decreased, unchanged and increased
/// @param width                 difference of the number between `over` and `under`, in its unit
/// @return  nullopt if the models differ in their free nodes, or in having creep or softening; then only differences of
///          runs give the derivative
std::optional<sensitivity::ModelTangent> affected_tangent(const Affected& under, const Affected& between,
                                                          const Affected& over, double width);

}  // namespace myo::effect
