#pragma once

#include "panels/panel.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// Draws the button in the corner of the view, and its popup with everything that the view can show. At ImGui's cursor.
void draw_view_options(PanelContext& context, const viewport::Camera& camera);

}  // namespace myo::ui::panels
