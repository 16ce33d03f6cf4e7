#pragma once

#include "panels/placing.hpp"
#include "panels/point_drag.hpp"

namespace myo::ui::panels {

/// Sets markers and probes in the view: a click on the body adds one, a click on one selects it, a drag moves it on the
/// surface, Delete removes the selected one.
class MarkerTool {
public:
    /// Whether a press at this pixel of the view belongs to the tool: there is a marker within `reach` [pixels].
    bool takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel, double reach) const;
    /// Handles clicks, drags and keys of a frame while the tool is on. Emits EditDeclaration and ChooseMarker.
    void update(const ToolView& tool, Placing& placing);
    /// Puts a dragged marker where it is held.
    void show(viewport::DrawnScene& drawn) const;
    /// Drops the drag in progress. Returns false if there is none.
    bool cancel();
    /// Changes whenever show() does.
    int revision() const { return drag_.revision(); }

private:
    PointDrag drag_;  // of a marker by its number
};

}  // namespace myo::ui::panels
