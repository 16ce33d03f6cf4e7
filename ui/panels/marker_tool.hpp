#pragma once

#include "panels/placing.hpp"
#include "panels/point_drag.hpp"

namespace myo::ui::panels {

/// Sets markers and probes in the view: a click on the body adds one, a click on one selects it, a drag moves it on the
/// surface, Delete removes the selected one.
class MarkerTool {
public:
    /// Whether a press at this pixel belongs to the tool: there is a marker.
    bool takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel, double reach) const;
    void update(const ToolView& tool, Placing& placing);
    /// Puts a dragged marker where it is held.
    void show(viewport::DrawnScene& drawn) const;
    bool cancel();  // the drag; false: there is none
    int revision() const { return drag_.revision(); }

private:
    PointDrag drag_;
};

}  // namespace myo::ui::panels
