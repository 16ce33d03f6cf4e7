#pragma once

#include <optional>

#include "panels/placing.hpp"
#include "panels/point_drag.hpp"

namespace myo::ui::panels {

/// Picks a part of the body in the view by one click: a face, around which a box is declared, or the wall of a cavity,
/// which becomes a chamber. What a click would take is shown while the mouse is over it.
class RegionTool {
public:
    /// Handles the mouse of a frame while the tool is on. A click emits EditDeclaration and ends the tool.
    void update(const ToolView& tool, Placing& placing);
    /// Tints what the mouse is over.
    void show(const platform::Theme& theme, viewport::DrawnScene& drawn) const;
    /// The mouse is over nothing.
    void clear();
    /// Changes with what the mouse is over.
    int revision() const { return revision_; }

private:
    /// Remembers what the mouse is over.
    void hover(const std::optional<Box>& box, int triangle);
    /// Picks a face: the triangles around the one under the mouse.
    void update_box(const ToolView& tool, Placing& placing);
    /// Picks the wall of a cavity that is no chamber yet.
    void update_cavity(const ToolView& tool, Placing& placing);

    std::optional<Box> hovered_m_;  // around what a click takes; empty: the mouse is over nothing to take
    int triangle_ = -1;             // under the mouse, in the declared surface
    int revision_ = 0;              // see revision()
};

}  // namespace myo::ui::panels
