#pragma once

#include <string>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// How the effect of this id, which must be in the catalogue, is drawn.
const effect::EffectDraw& effect_draw(const std::string& id);

/// Largest amount of an effect, which must be in the catalogue, in a case: that of its range, or less where the body or
/// the trials limit it.
double max_amount(const SyntheticCase& c, const std::string& id);

/// The effect with random parameters.
///
/// Its amount is the geometric mean of the plausible range, with a random sign if it may be negative; visible_effect()
/// then scales it.
/// @param body_and_trials  case whose body, markers and trials are complete
effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& body_and_trials,
                                       RandomStream& random);

/// Absolute amount of an effect, and the effect with another amount [unit of the parameter]; a vector keeps its
/// direction, a number its sign. Effects without an amount must not be given.
double effect_amount(const effect::EffectDeclaration& effect);
effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount);

}  // namespace myo::validation
