#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Draws switch, length and state of the live preview, in the panels in which values are adjusted. Draws nothing if no
/// scene is open.
///
/// @param edit  edit in progress in the length field
void draw_preview_rows(PanelContext& context, NumberEdits& edit);

}  // namespace myo::ui::panels
