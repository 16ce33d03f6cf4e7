#pragma once

#include "panels/panel.hpp"
#include "viewport/camera.hpp"

namespace myo {

/// Switch, direction, position and side of the plane that cuts the body.
///
/// @param view  to be changed
void draw_clip_options(PanelContext& context, const Camera& camera, ViewOptions& view);

}  // namespace myo
