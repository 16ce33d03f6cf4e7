#pragma once

#include <optional>

#include "effect/effect.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::effect {

/// Derivative of a model and of its start along a number of an effect, from both sides of it: exact where forces,
/// masses and starts are linear in the number, and otherwise to the square of the width.
///
/// width: between the sides, in units of the number. Nothing where both sides have other free nodes than what is
/// between them, or one is without the memory that it has: there only differences of runs tell.
std::optional<sensitivity::ModelTangent> affected_tangent(const Affected& under, const Affected& between,
                                                          const Affected& over, double width);

}  // namespace myo::effect
