#pragma once

#include "panels/number_field.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// Draws the controls of the clip plane: on or off, direction, position and side. Draws nothing without a meshed body.
///
/// @param camera  for the direction "View"
/// @param edits   edits in progress, kept by the caller between frames
/// @param view    options that the controls change; the caller emits them
void draw_clip_options(PanelContext& context, const viewport::Camera& camera, NumberEdits& edits,
                       commands::ViewOptions& view);

}  // namespace myo::ui::panels
