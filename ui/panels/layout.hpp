#pragma once

#include "commands/preferences.hpp"
#include "platform/item_rectangles.hpp"

namespace myo {

/// Where the parts of the window are [pixels].
struct Layout {
    Rectangle bar;        // top
    Rectangle steps;      // far left
    bool narrow = false;  // the steps have room for their icons only
    Rectangle rail;       // the side: panels of the chosen step
    Rectangle view;
    Rectangle timeline;
    Rectangle strip;      // bottom
    Rectangle rail_edge;  // to drag
    Rectangle strip_edge;
};

/// Divides the window; the view never gets less than a third of either side, whatever was dragged.
Layout make_layout(float width, float height, float scale, const LayoutSizes& sizes);

}  // namespace myo
