#pragma once

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// While labels of a recording are being placed, a click says which of the experiment's markers the chosen one is; on a
/// plain mesh, where on the body it sits. After the view; true while clicks are for it.
bool update_placing(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

}  // namespace myo::ui::panels
