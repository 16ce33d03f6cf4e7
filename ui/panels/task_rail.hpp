#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Draws the tasks from a body to a report with their states into the current window. A click requests the task.
///
/// @param narrow  icons only
void draw_task_rail(PanelContext& context, commands::Task chosen, bool narrow);

/// Draws the state of a task and what to do next, at the top of the side panel.
void draw_task_head(PanelContext& context, commands::Task task);

}  // namespace myo::ui::panels
