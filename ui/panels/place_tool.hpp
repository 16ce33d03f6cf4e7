#pragma once

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo {

/// While labels of a recording are being placed, a click on the body says where the chosen one sits.
/// After the view; true while clicks are for it.
bool update_placing(PanelContext& context, const DrawnScene& scene, const ViewportState& view);

}  // namespace myo
