#pragma once

#include "platform/item_rectangles.hpp"

namespace myo {

/// Sizes a person has dragged, in units of the UI scale.
struct LayoutSizes {
    float rail = 336.0f;
    float strip = 288.0f;
};

/// Where the parts of the window are [pixels].
struct Layout {
    Rectangle bar;        // top
    Rectangle rail;       // left
    Rectangle view;
    Rectangle timeline;
    Rectangle strip;      // bottom
    Rectangle rail_edge;  // to drag
    Rectangle strip_edge;
};

/// Divides the window; the view never gets less than a third of either side, whatever was dragged.
Layout make_layout(float width, float height, float scale, const LayoutSizes& sizes);

}  // namespace myo
