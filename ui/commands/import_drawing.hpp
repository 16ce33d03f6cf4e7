#pragma once

#include "commands/workbench_state.hpp"
#include "platform/theme.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// The markers of a recording that is being imported, at the state's time, where its choices put them; before the start
/// lines lead from there to where they sit on the body.
void add_import(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
