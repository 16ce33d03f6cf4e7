#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Draws the dialog with the version and the licences of the libraries in use.
///
/// @param open  whether it is shown; set to false when the user closes it
void draw_about(PanelContext& context, bool& open);

}  // namespace myo::ui::panels
