#pragma once

#include <functional>
#include <string>

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// What the person did to a 3D view.
struct ViewportState {
    Camera camera;
    bool fit_requested = true;                        // show the whole scene in the next frame
    bool untouched = true;                            // the person has not turned or moved it since all was shown
    bool moving = false;                              // the camera moved in this frame: draw without multisampling
    bool hovered = false;                             // by the mouse, with nothing over it
    bool clicked = false;                             // the left button was pressed and released in one place
    bool measuring = false;                           // clicks set the ends of distances
    bool tool_held = false;                           // the left button is down for a tool, not for the view
    Eigen::Vector2d mouse = Eigen::Vector2d::Zero();  // [pixels] from the upper left corner of the view
    platform::Rectangle pixels;                       // where the picture belongs in the window

    ViewSize size() const { return {static_cast<int>(pixels.width()), static_cast<int>(pixels.height())}; }
};

/// Whether a press of the left button at these pixels of the view is for a tool.
using ToolTakes = std::function<bool(const Eigen::Vector2d&)>;

/// Everything of a 3D view but the picture itself: mouse, labels, axes, scale bar, legend, buttons. Fills the current
/// ImGui window, which must have no background: the picture lies under it.
///
/// Left drag turns, unless a tool takes it; right or middle drag moves, wheel zooms towards the mouse; the buttons show
/// all or look along an axis.
void draw_viewport(const DrawnScene& scene, const platform::Theme& theme, platform::ItemRectangles& items,
                   ViewportState& state, bool labels, const ToolTakes& takes);

}  // namespace myo::ui::viewport
