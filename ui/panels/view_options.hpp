#pragma once

#include "panels/panel.hpp"

namespace myo {

/// The button in the view's corner with its list of what is shown. At ImGui's cursor.
void draw_view_options(PanelContext& context);

}  // namespace myo
