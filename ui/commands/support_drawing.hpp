#pragma once

#include "commands/workbench_state.hpp"
#include "platform/theme.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Draws the supports other than the clamp: the box, and in its middle a bar with stops along every held axis.
void add_supports(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
