#include "backend/effect_settings.hpp"

#include <utility>

#include "commands/effect_words.hpp"
#include "effect/readable_quantity.hpp"

namespace myo::backend {

ui::commands::AddedEffect added_effect(effect::EffectDeclaration effect) {
    effect.calibrate = true;
    std::string name = effect::effect_name(effect.id), words = ui::commands::effect_words(effect.parameters);
    return {std::move(effect), std::move(name), std::move(words)};
}

}  // namespace myo::backend
