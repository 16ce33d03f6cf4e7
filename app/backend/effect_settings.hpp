#pragma once

#include "commands/settings.hpp"
#include "effect/effect_declaration.hpp"

namespace myo::backend {

/// An effect as the window adds it: its parameters are fitted (`calibrate` is set, whatever the declaration says), with
/// its name and values as shown.
ui::commands::AddedEffect added_effect(effect::EffectDeclaration effect);

}  // namespace myo::backend
