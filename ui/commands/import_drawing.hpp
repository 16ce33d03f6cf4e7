#pragma once

#include "commands/workbench_state.hpp"
#include "platform/theme.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Adds the markers of the recording that is being imported to a drawn scene, at the state's time and placed by the
/// current choices. Lines lead from their positions before the start to their places on the body. Requires
/// state.import.
void add_import(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
