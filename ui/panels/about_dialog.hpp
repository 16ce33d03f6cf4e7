#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The version, and what the program stands on with its licences.
///
/// @param open  becomes false when it is closed
void draw_about(PanelContext& context, bool& open);

}  // namespace myo::ui::panels
