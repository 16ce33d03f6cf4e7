#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Draws the bar below the view: trial, play and pause, a track to move in time, the time and the speed. Fills the
/// current window.
void draw_timeline(PanelContext& context);

}  // namespace myo::ui::panels
