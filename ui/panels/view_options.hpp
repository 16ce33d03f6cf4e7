#pragma once

#include "panels/panel.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// The button in the view's corner with its list of what is shown. At ImGui's cursor.
void draw_view_options(PanelContext& context, const viewport::Camera& camera);

}  // namespace myo::ui::panels
