#pragma once

#include <string>

#include "effect/effect.hpp"

namespace myo::diagnosis {

/// "coefficient_kg_m3 = 900, ..." for a person; six digits.
std::string parameter_words(const effect::EffectParameters& parameters);

/// "quadratic_drag (coefficient_kg_m3 = 900)".
std::string effect_words(const effect::EffectDeclaration& effect);

}  // namespace myo::diagnosis
