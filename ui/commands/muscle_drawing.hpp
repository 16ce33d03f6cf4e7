#pragma once

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Tints the faces of painted cells and draws the fibres of all muscles. Does nothing without a meshed body, or if the
/// view hides muscles.
///
/// @param live  paint of the selected muscle during a stroke; null: the paint in the state
void add_muscles(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
                 const fibre::CellPaint* live);

}  // namespace myo::ui::commands
