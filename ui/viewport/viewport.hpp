#pragma once

#include <functional>
#include <string>

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// State of a 3D view between frames, and what the user did to it in this frame.
struct ViewportState {
    Camera camera;
    bool zoom_to_data_requested = true;               // zoom to the whole scene in the next frame
    bool untouched = true;                            // the user has not moved the camera since the last zoom to data
    bool moving = false;                              // the camera moved in this frame: render without multisampling
    bool hovered = false;                             // the mouse is over the view, with no other item in front
    bool clicked = false;                             // the left button was pressed and released in place
    bool measuring = false;                           // clicks set the ends of distances
    bool tool_held = false;                           // the left button is held by a tool, not by the camera
    Eigen::Vector2d mouse = Eigen::Vector2d::Zero();  // [pixels] from the upper left corner of the view
    platform::Rectangle pixels;                       // place of the image in the window

    /// The view's size in whole pixels.
    ViewSize size() const { return {static_cast<int>(pixels.width()), static_cast<int>(pixels.height())}; }
};

/// Decides whether a press of the left button at a pixel of the view (from its upper left corner) belongs to a tool. An
/// empty function means that the camera gets all presses.
using ToolTakes = std::function<bool(const Eigen::Vector2d&)>;

/// Draws everything of a 3D view except the image itself: labels, axes, scale bars, legend and buttons; and handles the
/// mouse.
///
/// Fills the current ImGui window, which must have no background because the image lies below it. Left drag turns the
/// camera, unless a tool takes it; right, middle or Shift and left drag moves it, the wheel zooms towards the mouse.
/// The buttons zoom to data or look along an axis. Does nothing in an empty scene or a view below 2 x 2 pixels.
///
/// @param labels  draw the markers' names
void draw_viewport(const DrawnScene& scene, const platform::Theme& theme, platform::ItemRectangles& items,
                   ViewportState& state, bool labels, const ToolTakes& takes);

}  // namespace myo::ui::viewport
