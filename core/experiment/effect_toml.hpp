#pragma once

#include <string>

#include "effect/effect_declaration.hpp"
#include "toml/toml_text.hpp"

namespace myo::experiment {

/// Value of an effect's parameter as TOML: a number, a text, or an array of either.
///
/// @param number  formats one number; the default keeps all digits
/// @return        the right-hand side of `key = value`, which read_effects() reads back
std::string effect_toml(const effect::EffectParameter& value, std::string (*number)(double) = toml::toml_number);

}  // namespace myo::experiment
