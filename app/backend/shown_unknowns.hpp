#pragma once

#include "commands/scene_unknown.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// The values that a fit of this setup finds, in its order, with the bounds that hold and those that [[unknown]] of the
/// experiment declares. SI.
ui::commands::SceneUnknowns shown_unknowns(const setup::Setup& setup);

}  // namespace myo::backend
