#pragma once

#include <memory>
#include <optional>

#include "panels/panel.hpp"
#include "viewport/picking.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The brush in the 3D view. Strokes begin on the body; a drag that begins beside it turns the view as ever. With Ctrl
/// held the brush erases, or paints where it would erase.
class PaintTool {
public:
    /// Whether a press at these pixels of the view is for the brush.
    bool takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
               const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const;

    /// After the view: goes on with the stroke, draws the ring at the mouse, and hands a finished stroke over.
    void update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

    /// Paint of the chosen muscle with the stroke so far; null between strokes.
    const fibre::CellPaint* live() const { return live_ ? &*live_ : nullptr; }
    /// Another number whenever live() is another paint.
    int revision() const { return revision_; }

private:
    /// A place on the body below the mouse.
    struct Touch {
        viewport::SurfaceHit hit;
        int face = 0;             // of those drawn
        Eigen::Vector3d rest_m;   // at rest
        Eigen::Vector3d outward;  // there
    };
    static std::optional<viewport::SurfaceHit> hit_at(const commands::WorkbenchState& state,
                                                      const viewport::DrawnScene& scene,
                                                      const viewport::ViewportState& view,
                                                      const Eigen::Vector2d& pixel);

    void press(PanelContext& context, const viewport::DrawnScene& scene, const Touch& touch);
    void go_on(const commands::WorkbenchState& state, const Touch& touch);
    void drop();
    void draw_ring(const PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                   const Touch& touch) const;

    bool was_held_ = false;
    bool handed_over_ = false;                             // the stroke, in the last frame
    std::shared_ptr<const commands::PaintGround> ground_;  // of the stroke
    int muscle_ = 0;                                       // of the stroke
    std::unique_ptr<fibre::Stroke> stroke_;
    Eigen::Vector3d last_ = Eigen::Vector3d::Zero();  // place of its last point at rest [m]
    std::optional<fibre::CellPaint> live_;
    int revision_ = 0;
};

}  // namespace myo::ui::panels
