#pragma once

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// The bar at the top: menus with their keys, undo and redo, the last message, size and colours. Fills the current
/// window.
void draw_menu_bar(PanelContext& context, viewport::ViewportState& viewport);

}  // namespace myo::ui::panels
