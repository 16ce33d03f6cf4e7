#pragma once

#include <string>

#include "effect/effect.hpp"

namespace myo::diagnosis {

/// Text such as "coefficient_kg_m3 = 900, ..."; six digits.
std::string parameter_words(const effect::EffectParameters& parameters);

/// Text such as "quadratic_drag (coefficient_kg_m3 = 900)".
std::string effect_words(const effect::EffectDeclaration& effect);

}  // namespace myo::diagnosis
