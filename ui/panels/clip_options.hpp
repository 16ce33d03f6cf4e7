#pragma once

#include "panels/panel.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// Switch, direction, position and side of the plane that cuts the body.
///
/// @param view  to be changed
void draw_clip_options(PanelContext& context, const viewport::Camera& camera, commands::ViewOptions& view);

}  // namespace myo::ui::panels
