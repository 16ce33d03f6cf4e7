#pragma once

#include <vector>

#include "panels/placing.hpp"
#include "panels/point_drag.hpp"

namespace myo::ui::panels {

/// Draws a tendon in the view: each click on the body adds a guide, Enter ends. Guides are dragged in the plane of the
/// view; Delete removes the one that was clicked last.
class TendonTool {
public:
    /// Whether a press at this pixel of the view belongs to the tool: there is a guide within `reach` [pixels].
    bool takes(const commands::WorkbenchState& state, const Placing& placing, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel, double reach) const;
    /// Handles clicks, drags and keys of a frame while the tool is on. Emits EditDeclaration.
    void update(const ToolView& tool, Placing& placing);
    /// Draws the thread with its guides where they are held.
    void show(const platform::Theme& theme, viewport::DrawnScene& drawn) const;
    /// Drops the drag, or the guides of a new tendon. Returns false if there is neither.
    bool cancel();
    /// Changes whenever show() does.
    int revision() const { return revision_ + drag_.revision(); }

    /// Guides of the new tendon so far.
    std::size_t begun() const { return begun_m_.size(); }

private:
    /// Guides that the tool works on [m]: those of the declared tendon, or of the new one so far.
    std::vector<Eigen::Vector3d> guides(const commands::WorkbenchState& state, const Placing& placing) const;
    /// Follows the drag of a guide. Returns whether the mouse is for a guide.
    bool drag_guides(const ToolView& tool, const Placing& placing, std::vector<Eigen::Vector3d>& places);
    /// Delete removes the guide that was clicked last, Enter ends the tool.
    void react_to_keys(const ToolView& tool, Placing& placing, const std::vector<Eigen::Vector3d>& places);

    PointDrag drag_;                        // of a guide by its index
    std::vector<Eigen::Vector3d> begun_m_;  // guides of a new tendon [m]
    std::vector<Eigen::Vector3d> shown_m_;  // all guides, the held one where it is held
    int chosen_ = -1;                       // guide that was clicked last; -1: none
    int revision_ = 0;                      // of shown_m_
};

}  // namespace myo::ui::panels
