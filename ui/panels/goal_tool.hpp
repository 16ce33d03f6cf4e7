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
        std::size_t goal = 0;
        Eigen::Index point = 0;  // of a path
    };
    struct Drag {
        Handle handle;
        Eigen::Vector3d offset_m;  // from the point under the mouse to the place
        Eigen::Vector3d place_m;   // now
        bool moved = false;
    };
    static std::optional<Handle> handle_at(const commands::WorkbenchState& state, const platform::Theme& theme,
                                           const viewport::ViewportState& view, const Eigen::Vector2d& pixel);
    /// Places of a goal with the drag in progress.
    Eigen::Matrix3Xd places(const commands::SceneGoal& goal, std::size_t index) const;
    void press(const commands::WorkbenchState& state, const platform::Theme& theme,
               const viewport::ViewportState& view);
    void release(PanelContext& context);
    void draw(PanelContext& context, const viewport::ViewportState& view) const;

    std::optional<Drag> drag_;
    bool was_held_ = false;  // the button was held by a tool in the last frame
};

}  // namespace myo::ui::panels
