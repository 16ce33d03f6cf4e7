#pragma once

#include "commands/settings.hpp"
#include "effect/effect.hpp"

// Effects of the core as the workbench stores them.

namespace myo::backend {

/// An effect of the core as the window stores it; inverse of declaration().
ui::commands::AddedEffect added_effect(const effect::EffectDeclaration& effect);

/// An effect added in the window as an experiment declares it, with calibrate = true.
effect::EffectDeclaration declaration(const ui::commands::AddedEffect& effect);

}  // namespace myo::backend
