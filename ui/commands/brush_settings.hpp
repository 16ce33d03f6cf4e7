#pragma once

#include "commands/paint_ground.hpp"
#include "fibre/brush.hpp"

namespace myo::ui::commands {

enum class BrushTool { none, add, erase, fill };         // none: the mouse turns the view
enum class BrushDirection { stroke, x, y, z, longest };  // longest: the body's
enum class BrushMirror { none, x, y, z };                // planes through the middle of the body, by their normal

/// How a person paints.
struct BrushSettings {
    BrushTool tool = BrushTool::none;
    double radius_m = 0.01;
    double depth_m = 0.005;
    bool through = false;   // the whole body, whatever the depth
    double falloff = 0.0;   // 0 ... 1
    double strength = 1.0;  // 0 ... 1
    BrushDirection direction = BrushDirection::stroke;
    BrushMirror mirror = BrushMirror::none;

    bool operator==(const BrushSettings&) const = default;
};

/// One that suits a body of this size.
BrushSettings brush_for(const Eigen::Vector3d& size_m);

/// The brush of the core. @param erase  whatever the tool
fibre::Brush make_brush(const BrushSettings& settings, const PaintGround& ground, bool erase);

/// Where fibres run that no stroke gives a direction: the fixed axis, or the body's longest.
Eigen::Vector3d fixed_axis(BrushDirection direction, const PaintGround& ground);

}  // namespace myo::ui::commands
