#pragma once

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

struct ImDrawList;

namespace myo {

// What is drawn over a 3D picture. `view`: its rectangle in the window.

/// A length of 1, 2 or 5 times a power of ten whose bar is at most `longest` pixels, as at the camera's target.
struct ScaleBar {
    double length_m = 0.0;
    double pixels = 0.0;
    std::string label;             // "20 mm"
};
ScaleBar make_scale_bar(double metres_per_pixel, double longest);
/// Of forces: length_m is newtons then, and the label "5 mN".
ScaleBar make_force_bar(double newtons_per_pixel, double longest);

void draw_scale_bar(ImDrawList& list, const Rectangle& view, const Camera& camera, const Theme& theme);
/// The same for arrows of a force, above it.
void draw_arrow_scale(ImDrawList& list, const Rectangle& view, const Camera& camera, const ArrowScale& arrows, const Theme& theme);
void draw_axes(ImDrawList& list, const Rectangle& view, const Camera& camera, const Theme& theme);
void draw_marker_labels(ImDrawList& list, const Rectangle& view, const Camera& camera, const DrawnScene& scene, const Theme& theme);
void draw_field_legend(ImDrawList& list, const Rectangle& view, const DrawnField& field, const Theme& theme);

}  // namespace myo
