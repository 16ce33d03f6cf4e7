#pragma once

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Handles clicks in the view while labels of a recording are placed: a click assigns a declared marker to the selected
/// label, or on a plain mesh its position on the body. Call it after the view. Returns true while clicks belong to this
/// tool.
bool update_placing(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

}  // namespace myo::ui::panels
