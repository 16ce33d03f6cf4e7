#pragma once

#include <string>
#include <vector>

#include "effect/effect.hpp"

namespace myo::effect {

/// All effects, in the order of the vocabulary. "none" and "unknown" are verdicts and not effects.
/// Made once; pointers to its entries stay valid for the whole program.
const std::vector<Effect>& effect_catalogue();

/// Entry of the catalogue with this id; null if there is none.
const Effect* find_effect(const std::string& id);
/// Entry with this id among the laws, then in the catalogue; null if there is none.
/// The pointer is valid as long as `laws` keep the law.
const Effect* find_effect(const std::string& id, const Laws& laws);
/// Entry of a declared effect or candidate; null if there is none.
const Effect* find_effect(const EffectDeclaration& declaration);

/// The law with this id; null if none has it.
LawPointer find_law(const std::string& id, const Laws& laws);

/// Entries of the catalogue, then those of the laws.
std::vector<const Effect*> all_effects(const Laws& laws);

/// Ids of all effects, in the order of the catalogue, then those of the laws.
std::vector<std::string> effect_ids(const Laws& laws = {});

/// Whether any of these effects varies within cells; their body then requires fine_element().
bool any_varies_within_cells(const std::vector<EffectDeclaration>& effects);

/// Whether the force of any of these effects has a corner, see Effect::has_corner.
bool any_has_corner(const std::vector<EffectDeclaration>& effects);

/// Applies effects ordered by EffectKind, and by declaration within each of them. Effects for other trials are
/// skipped. Asserts that all have an entry.
/// At the end the body is put on its mount, if that moves: forces that act from the laboratory are seen from the mount,
/// and inertia forces are added. Hence to be called once per trial, with all effects.
void apply_effects(const TrialContext& context, const std::vector<EffectDeclaration>& effects, Affected& affected);

}  // namespace myo::effect
