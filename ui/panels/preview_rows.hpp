#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Switch, length and state of the live preview, for the steps in which values are tuned. @param edit  of the length's
/// field
void draw_preview_rows(PanelContext& context, OpenEdit& edit);

}  // namespace myo::ui::panels
