#pragma once

#include <memory>
#include <optional>

#include "panels/panel.hpp"
#include "viewport/picking.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The brush in the 3D view. A stroke begins on the body; a drag that begins outside of it turns the camera. Ctrl
/// swaps painting and erasing, Shift leaves the drag to the camera.
///
/// During a stroke the tool keeps the paint itself, so that the view shows it at once; the state changes only when the
/// stroke is finished, as one undo entry.
class PaintTool {
public:
    /// Whether a press at this pixel of the view (from its upper left corner) belongs to the brush.
    bool takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const;

    /// Continues the stroke, draws the ring at the mouse, and emits the paint of a finished stroke. Call it after
    /// draw_viewport(), within the view's window.
    void update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

    /// Paint of the selected muscle or part including the present stroke; null between strokes. Valid until the next
    /// update().
    const fibre::CellPaint* live() const { return live_ ? &*live_ : nullptr; }
    /// Changes whenever the paint of live() does, so that the view is drawn again.
    int revision() const { return revision_; }

private:
    /// The point of the body under the mouse.
    struct Touch {
        viewport::SurfaceHit hit;  // on the drawn surface
        int face = 0;              // index in the drawn boundary
        Eigen::Vector3d rest_m;    // position at rest [m]
        Eigen::Vector3d outward;   // outward unit normal at rest
    };
    /// The left button went down on the body: a stroke begins, or a region is filled.
    void press(PanelContext& context, const viewport::DrawnScene& scene, const Touch& touch);
    /// The left button is held with the mouse on the body: the stroke is extended.
    void go_on(const commands::WorkbenchState& state, const Touch& touch);
    /// Drops stroke and paint without emitting anything.
    void drop();
    /// Draws the brush at the mouse, deformed with the body.
    void draw_ring(const PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                   const Touch& touch) const;

    bool was_held_ = false;                                // the button was held in the last frame
    bool handed_over_ = false;                             // the finished stroke was emitted in the last frame
    std::shared_ptr<const commands::PaintGround> ground_;  // of the stroke
    int muscle_ = 0;                                       // index of the stroke's muscle
    int part_ = -1;                                        // BrushSettings::part of the stroke
    std::unique_ptr<fibre::Stroke> stroke_;                // null: no stroke
    Eigen::Vector3d last_ = Eigen::Vector3d::Zero();       // last point of the stroke at rest [m]
    std::optional<fibre::CellPaint> live_;                 // see live()
    int revision_ = 0;                                     // see revision()
};

}  // namespace myo::ui::panels
