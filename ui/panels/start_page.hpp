#pragma once

#include "panels/panel.hpp"

namespace myo {

/// What stands in the view's place while nothing is open: examples, what was open lately, and how to open something else. Fills the current window.
void draw_start_page(PanelContext& context);

}  // namespace myo
