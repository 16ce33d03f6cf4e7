#pragma once

#include <cstddef>
#include <optional>

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The goals of the shown trial in the view: a cross in a ring at each goal, and a line to it from where its marker is
/// in the shown run at that time. A drag moves a goal in the plane of the image through its place. Its new place is
/// emitted when the button is released, as one edit.
class GoalTool {
public:
    /// Whether a press at this pixel of the view (from its upper left corner) takes a goal.
    bool takes(const commands::WorkbenchState& state, const platform::Theme& theme, const viewport::ViewportState& view,
               const Eigen::Vector2d& pixel) const;

    /// Continues a drag and draws. Call it after draw_viewport(), within the view's window.
    void update(PanelContext& context, const viewport::ViewportState& view);

private:
    /// A place of a goal that can be moved.
    struct Handle {
        std::size_t goal = 0;    // index in SceneTrial::goals
        Eigen::Index point = 0;  // of a path
    };
    /// A drag in progress, from the press on a goal to the release.
    struct Drag {
        Handle handle;
        Eigen::Vector3d offset_m;  // from the point under the mouse to the place [m]
        Eigen::Vector3d place_m;   // now [m]
        bool moved = false;        // otherwise nothing is emitted
    };
    /// The nearest place of a goal within reach of a pixel; empty: none. Goals from a file cannot be moved.
    static std::optional<Handle> handle_at(const commands::WorkbenchState& state, const platform::Theme& theme,
                                           const viewport::ViewportState& view, const Eigen::Vector2d& pixel);
    /// Places of a goal with the drag in progress [m], 3 x n.
    Eigen::Matrix3Xd places(const commands::SceneGoal& goal, std::size_t index) const;
    /// Begins a drag if the press is on a goal.
    void press(const commands::WorkbenchState& state, const platform::Theme& theme,
               const viewport::ViewportState& view);
    /// Ends the drag; emits the new place of a goal that has moved.
    void release(PanelContext& context);
    /// Draws paths, goals and the lines from the markers to them.
    void draw(PanelContext& context, const viewport::ViewportState& view) const;

    std::optional<Drag> drag_;  // empty: nothing is dragged
    bool was_held_ = false;     // the button was held by a tool in the last frame
};

}  // namespace myo::ui::panels
