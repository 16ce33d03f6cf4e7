#pragma once

#include <string>

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo {

/// What the person did to a 3D view.
struct ViewportState {
    Camera camera;
    bool fit_requested = true;     // show the whole scene in the next frame
    bool untouched = true;         // the person has not turned or moved it since all was shown
    bool moving = false;           // the camera moved in this frame: draw without multisampling
    Rectangle pixels;              // where the picture belongs in the window

    ViewSize size() const { return {static_cast<int>(pixels.width()), static_cast<int>(pixels.height())}; }
};

/// Text for a view that has nothing to show.
struct EmptyView {
    std::string title;
    std::string hint;
};

/// Everything of a 3D view but the picture itself: mouse, labels, axes, scale bar, legend, buttons. Fills the current ImGui
/// window, which must have no background: the picture lies under it.
///
/// Left drag turns, right or middle drag moves, wheel zooms towards the mouse; the buttons show all or look along an axis.
void draw_viewport(const DrawnScene& scene, const EmptyView& empty, const Theme& theme, ItemRectangles& items,
                   ViewportState& state, bool labels);

}  // namespace myo
