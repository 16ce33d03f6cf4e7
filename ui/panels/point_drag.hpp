#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>

#include "mesh/surface_patch.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

// What the tools share that set places on the body by mouse.

namespace myo::ui::panels {

/// What a tool of the view works on in a frame.
struct ToolView {
    PanelContext& context;                // for commands and hints
    const viewport::DrawnScene& scene;    // with the body at rest
    const viewport::ViewportState& view;  // camera and mouse
    const mesh::SurfacePatches& surface;  // declared surface of the body, at rest

    /// Distance within which a click selects a point [pixels].
    double reach() const;
    /// Whether the view was clicked in this frame, with a body that can be picked.
    bool clicked() const;
};

/// The declared surface of the body for nearest points, kept until another body is shown.
class PickedSurface {
public:
    /// The surface of a scene, prepared again if it differs from the last one. Valid until the next call.
    const mesh::SurfacePatches& of(const commands::Scene& scene);

private:
    mesh::SurfaceMesh surface_;  // of patches_, to see whether a scene has another one
    std::unique_ptr<mesh::SurfacePatches> patches_;
};

/// Point of the declared surface under the mouse, with its triangle; empty outside of the body. The body is drawn at
/// rest.
std::optional<mesh::SurfaceDistance::Nearest> surface_under_mouse(const ToolView& tool);

/// Drag of one of several points, from the press that the tool takes to the release.
class PointDrag {
public:
    /// How the drag ended in this frame.
    enum class End {
        none,   // goes on, or there is none
        click,  // released without having moved
        drop    // released at place_m()
    };

    /// Follows the mouse.
    ///
    /// @param under_mouse  index of the point there; read at the press
    /// @param place        where the point goes, for its index; empty: it stays
    End follow(const viewport::ViewportState& view, const std::optional<std::size_t>& under_mouse,
               const std::function<std::optional<Eigen::Vector3d>(std::size_t)>& place);
    /// Drops the drag without a result.
    void cancel();

    /// The held point, or that of the last End; -1: none.
    int point() const { return point_; }
    /// Where it has been dragged to; empty: it has not moved.
    const std::optional<Eigen::Vector3d>& place_m() const { return place_m_; }
    /// Whether a drag is in progress.
    bool held() const { return held_; }
    /// Changes whenever the dragged place does, so that the view is drawn again.
    int revision() const { return revision_; }

private:
    int point_ = -1;                          // see point()
    bool held_ = false;                       // see held()
    bool refused_ = false;                    // cancelled while the button is still down
    std::optional<Eigen::Vector3d> place_m_;  // see place_m()
    int revision_ = 0;                        // see revision()
};

/// Draws a ring around a place in the view.
void draw_place_ring(const ToolView& tool, const Eigen::Vector3d& place_m);

}  // namespace myo::ui::panels
