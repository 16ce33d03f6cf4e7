#pragma once

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Draws the bar at the top: menus with shortcuts, save, undo and redo, the newest message, the summary of checks,
/// scale and theme. Fills the current window.
void draw_menu_bar(PanelContext& context, viewport::ViewportState& viewport);

}  // namespace myo::ui::panels
