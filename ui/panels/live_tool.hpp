#pragma once

#include <optional>

#include "panels/panel.hpp"
#include "viewport/picking.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The hand in the 3D view while a model plays live: a drag that begins on the body pulls the patch under the mouse by
/// a spring, within the plane through it that faces the camera. Shift leaves the drag to the camera. Also says in the
/// view how fast the model plays and with which force it is pulled.
class LiveTool {
public:
    /// Whether a press at this pixel of the view (from its upper left corner) belongs to the hand.
    bool takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const;

    /// Begins, continues and ends the pull; draws spring, force and rate. Call it after draw_viewport(), within the
    /// view's window.
    ///
    /// @param placing  the view shows the body at rest, and another tool has the mouse
    void update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                bool placing);

private:
    /// Takes the patch under the mouse, if nothing is held yet, and moves the spring's end to the mouse.
    void pull(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);
    /// Lets go of the patch.
    void release(PanelContext& context);

    bool was_held_ = false;                         // the button was held in the last frame
    std::optional<commands::LiveGrip> grip_;        // empty: nothing is pulled
    Eigen::Vector3d plane_point_m_{0.0, 0.0, 0.0};  // of the plane in which the mouse moves
};

}  // namespace myo::ui::panels
