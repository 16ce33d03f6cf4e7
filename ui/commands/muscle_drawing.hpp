#pragma once

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Colours the faces of painted cells and draws their fibres, on the surface where cells have a face there, else
/// inside.
///
/// @param live  paint of the chosen muscle while a stroke goes on; null: as it is in the state
void add_muscles(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
                 const fibre::CellPaint* live);

}  // namespace myo::ui::commands
