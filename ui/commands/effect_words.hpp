#pragma once

#include <string>

#include "effect/effect_declaration.hpp"

namespace myo::ui::commands {

/// Values of an effect as they are shown: "coefficient 903 kg/m³; position 1, 2, 3 mm".
std::string effect_words(const effect::EffectParameters& parameters);

/// TOML text of one value, in SI units: a number, a name, or a list of either.
std::string declared_text(const effect::EffectParameter& value);

/// Lines of an [[effect]] with all values that it has: in the order of its catalogue entry, or, without one, by name.
std::string effect_text(const effect::EffectDeclaration& effect);

/// Lines of a new [[effect]] with the parameters that it needs; asserts that it is in the catalogue.
std::string new_effect_text(const effect::EffectDeclaration& effect);

}  // namespace myo::ui::commands
