#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Draws switch, length and state of the live preview, in the panels in which values are adjusted. Draws nothing if no
/// scene is open.
///
/// @param edit  drag in progress in the length field
void draw_preview_rows(PanelContext& context, OpenEdit& edit);

}  // namespace myo::ui::panels
