#pragma once

#include <string>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// How the effect of this id, which must be in the catalogue, is drawn.
const effect::EffectDraw& effect_draw(const std::string& id);

/// Largest amount of the case's own effect, which must be in the catalogue.
double max_amount(const SyntheticCase& c);

/// The effect with random parameters; its amount is the geometric mean of the plausible range, with a random sign if it
/// may be negative.
effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& body_and_trials,
                                       RandomStream& random);

/// Absolute amount of an effect, and the effect with another amount; a vector keeps its direction.
double effect_amount(const effect::EffectDeclaration& effect);
effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount);

}  // namespace myo::validation
