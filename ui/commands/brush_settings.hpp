#pragma once

#include "commands/paint_ground.hpp"
#include "fibre/brush.hpp"

namespace myo::ui::commands {

enum class BrushTool { none, add, erase, fill };         // none: the mouse moves the camera
enum class BrushDirection { stroke, x, y, z, longest };  // fibre direction; longest: longest axis of the body
enum class BrushMirror { none, x, y, z };                // normal of a plane through the middle of the body

/// Settings of the brush that paints muscles on the body.
struct BrushSettings {
    BrushTool tool = BrushTool::none;
    double radius_m = 0.01;  // [m], measured along the surface
    double depth_m = 0.005;  // [m] below the surface
    bool through = false;    // paint through the whole body; depth_m is ignored
    double falloff = 0.0;    // share of the radius with a soft edge, 0 to 1
    double strength = 1.0;   // weight in the middle of the brush, 0 to 1
    BrushDirection direction = BrushDirection::stroke;
    BrushMirror mirror = BrushMirror::none;
    int part = -1;  // part that is painted, index in Scene::parts, the number of parts for a new one; -1: the muscle

    bool operator==(const BrushSettings&) const = default;
};

/// Returns brush settings that suit a body: its size and how thick it is on average.
///
/// @param surface  vertices [m]; the volume that a closed one encloses gives the thickness
BrushSettings brush_for(const mesh::SurfaceMesh& surface);

/// Converts the settings to a brush of the core. Radius and depth are at least a fraction of a cell.
///
/// @param erase  whether the stroke removes paint, whatever the tool says
fibre::Brush make_brush(const BrushSettings& settings, const PaintGround& ground, bool erase);

/// Fibre direction for paint that has no stroke: the fixed axis, or the longest axis of the body. Unit vector, rest
/// frame.
Eigen::Vector3d fixed_axis(BrushDirection direction, const PaintGround& ground);

}  // namespace myo::ui::commands
