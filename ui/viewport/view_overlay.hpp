#pragma once

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

struct ImDrawList;

namespace myo::ui::viewport {

// What is drawn over a 3D picture. `view`: its rectangle in the window.

/// A length, or a force, of 1, 2 or 5 times a power of ten whose bar is at most `longest` pixels.
struct ScaleBar {
    double length = 0.0;  // [m] or [N]
    double pixels = 0.0;
    std::string label;  // "20 mm", "5 mN"
};
/// @param unit  of the length: "m", or "N" for the arrows of a force
ScaleBar make_scale_bar(double per_pixel, double longest, const std::string& unit);

/// Axes, scale bars, the legend of the field and, with `names`, the markers' names.
void draw_view_overlay(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const DrawnScene& scene,
                       const platform::Theme& theme, bool names);

/// A line of words in the upper left corner.
void draw_view_title(ImDrawList& list, const platform::Rectangle& view, const std::string& title,
                     const platform::Theme& theme);

}  // namespace myo::ui::viewport
