#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The steps from a body to a report, each with its state, in the current window. A click asks for the step.
/// @param narrow  icons only
void draw_step_rail(PanelContext& context, commands::Step chosen, bool narrow);

/// The step's title, and what is to be done in it.
void draw_step_head(PanelContext& context, commands::Step step);

}  // namespace myo::ui::panels
