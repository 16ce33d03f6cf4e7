#pragma once

#include "commands/preferences.hpp"
#include "platform/item_rectangles.hpp"

namespace myo::ui::panels {

/// Where the parts of the window are [pixels].
struct Layout {
    platform::Rectangle bar;    // top
    platform::Rectangle steps;  // far left
    bool narrow = false;        // the steps have room for their icons only
    platform::Rectangle rail;   // the side: panels of the chosen step
    platform::Rectangle view;
    platform::Rectangle timeline;
    platform::Rectangle strip;      // bottom
    platform::Rectangle rail_edge;  // to drag
    platform::Rectangle strip_edge;
};

/// Divides the window; the view never gets less than a third of either side, whatever was dragged.
Layout make_layout(float width, float height, float scale, const commands::LayoutSizes& sizes);

}  // namespace myo::ui::panels
