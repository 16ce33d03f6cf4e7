#pragma once

#include <functional>
#include <string>

#include "effect/effect_declaration.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// An effect whose values are edited.
struct EditedEffect {
    const effect::EffectDeclaration& effect;  // as it is now
    const effect::EffectDeclaration* start;   // values that optional parameters begin with; null: none can be given
    std::string item;                         // of the effect, for the names of the fields
    /// Receives a changed value, or null if the parameter is no longer given.
    std::function<void(const std::string& key, const effect::EffectParameter* value, bool goes_on)> change;
};

/// A row for each parameter of an effect of the catalogue: numbers with their units, names from lists. Item names are
/// that of the effect and the key of the parameter: "effect/declared/0/mass_kg".
void effect_rows(PanelContext& context, const EditedEffect& edited, NumberEdits& edits);

}  // namespace myo::ui::panels
