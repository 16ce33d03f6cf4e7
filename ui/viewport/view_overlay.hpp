#pragma once

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

struct ImDrawList;

namespace myo::ui::viewport {

// Annotations over a 3D view. `view` is the rectangle of the view in the window [pixels]; all functions draw into
// `list`.

/// A length or force of 1, 2 or 5 times a power of ten, whose bar is at most `longest` pixels long.
struct ScaleBar {
    double length = 0.0;  // [m] or [N]
    double pixels = 0.0;  // length of the bar
    std::string label;    // "20 mm", "5 mN"
};
/// @param per_pixel  length [m] or force [N] that one pixel stands for; positive
/// @param longest  maximum length of the bar [pixels]
/// @param unit  "m", or "N" for force arrows
ScaleBar make_scale_bar(double per_pixel, double longest, const std::string& unit);

/// Draws axes, scale bars, the legend of the field and, if `names` is true, the markers' names.
void draw_view_overlay(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const DrawnScene& scene,
                       const platform::Theme& theme, bool names);

/// Draws one line of text in the upper left corner, such as the time of a video frame.
void draw_view_title(ImDrawList& list, const platform::Rectangle& view, const std::string& title,
                     const platform::Theme& theme);

}  // namespace myo::ui::viewport
