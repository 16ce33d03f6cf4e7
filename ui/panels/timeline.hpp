#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The bar below the view: trial, play and pause, a track to scrub with the start of motion marked, time and speed.
void draw_timeline(PanelContext& context);

}  // namespace myo::ui::panels
