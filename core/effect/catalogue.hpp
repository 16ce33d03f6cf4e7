#pragma once

#include <string>
#include <vector>

#include "effect/effect.hpp"

namespace myo::effect {

/// All effects, in the order of the vocabulary. "none" and "unknown" are verdicts, not effects.
const std::vector<Effect>& effect_catalogue();

/// The entry with this id, or null.
const Effect* find_effect(const std::string& id);

std::vector<std::string> effect_ids();

/// Whether one of these effects varies within cells: their body needs fine_element().
bool any_varies_within_cells(const std::vector<EffectDeclaration>& effects);

/// Applies effects stage by stage, within a stage in their order. Asserts that they are of the catalogue.
void apply_effects(const EffectSite& site, const std::vector<EffectDeclaration>& effects, Affected& affected);

}  // namespace myo::effect
