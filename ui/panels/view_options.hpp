#pragma once

#include "panels/number_field.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// Draws the button in the corner of the view, and its popup with everything that the view can show. At ImGui's cursor.
///
/// @param edits  edits in progress in its number fields
void draw_view_options(PanelContext& context, const viewport::Camera& camera, NumberEdits& edits);

}  // namespace myo::ui::panels
