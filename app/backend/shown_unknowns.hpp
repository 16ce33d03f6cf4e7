#pragma once

#include "commands/scene_unknown.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// The values that a fit of this setup finds, in its order, with bounds.
ui::commands::SceneUnknowns shown_unknowns(const setup::Setup& setup);

}  // namespace myo::backend
