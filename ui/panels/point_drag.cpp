#include "panels/point_drag.hpp"

#include <imgui.h>

#include <cmath>

#include "commands/picked_place.hpp"
#include "panels/view_points.hpp"
#include "viewport/picking.hpp"

namespace myo::ui::panels {

double ToolView::reach() const { return static_cast<double>(marker_reach * context.theme.scale); }

// For a frame the scene may still show the previous mesh.
bool ToolView::clicked() const {
    return view.clicked && context.state.body && scene.positions.cols() == context.state.body->mesh.node_count();
}

const mesh::SurfacePatches& PickedSurface::of(const commands::Scene& scene) {
    const mesh::SurfaceMesh& surface = scene.surface;
    // By value: every edit of the declaration makes another scene, mostly with the same surface.
    const bool same = patches_ && surface.vertices.cols() == surface_.vertices.cols() &&
                      surface.triangles.cols() == surface_.triangles.cols() && surface.vertices == surface_.vertices &&
                      surface.triangles == surface_.triangles;
    if (!same) {
        surface_ = surface;
        patches_ = std::make_unique<mesh::SurfacePatches>(surface);
    }
    return *patches_;
}

std::optional<mesh::SurfaceDistance::Nearest> surface_under_mouse(const ToolView& tool) {
    // Reach 0: only the body.
    const auto place = commands::pick_place(tool.context.state, tool.scene, tool.view.camera, tool.view.size(),
                                            tool.view.mouse, 0.0);
    if (!place || place->marker >= 0) return std::nullopt;
    // The mesh may be coarser than the surface, on which markers must lie.
    return tool.surface.nearest(commands::place_at_rest(*place, tool.context.state));
}

PointDrag::End PointDrag::follow(const viewport::ViewportState& view, const std::optional<std::size_t>& under_mouse,
                                 const std::function<std::optional<Eigen::Vector3d>(std::size_t)>& place) {
    // After a cancel the point is taken again only by another press.
    if (!view.tool_held) refused_ = false;
    if (view.tool_held && !held_ && !refused_) {
        if (!under_mouse) return End::none;
        held_ = true;
        point_ = static_cast<int>(*under_mouse);
        place_m_.reset();
    }
    // From here on the point is held, or was held in the last frame.
    if (!held_) return End::none;
    const ImGuiIO& io = ImGui::GetIO();
    // A hand that trembles during a click does not move the point.
    const bool moved = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >=
                       io.MouseDragThreshold * io.MouseDragThreshold;
    if (view.tool_held) {
        const auto to = moved ? place(static_cast<std::size_t>(point_)) : std::nullopt;
        if (to && (!place_m_ || *to != *place_m_)) {
            place_m_ = to;
            ++revision_;
        }
        return End::none;
    }
    held_ = false;
    ++revision_;
    return place_m_ ? End::drop : End::click;
}

void PointDrag::cancel() {
    refused_ = held_;
    held_ = false;
    if (place_m_) ++revision_;
    place_m_.reset();
    point_ = -1;
}

void draw_place_ring(const ToolView& tool, const Eigen::Vector3d& place_m) {
    const auto at = window_pixel(tool.view, place_m);
    if (!at) return;
    const float s = tool.context.theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircle(*at, 11.0f * s, IM_COL32(0, 0, 0, 160), 0, 4.0f * s);
    list.AddCircle(*at, 11.0f * s, platform::packed(tool.context.theme.accent), 0, 2.0f * s);
}

}  // namespace myo::ui::panels
