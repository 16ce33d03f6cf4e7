#include "panels/marker_tool.hpp"

#include <imgui.h>

#include "commands/picked_place.hpp"
#include "panels/marker_edits.hpp"
#include "panels/view_points.hpp"

namespace myo::ui::panels {
namespace {

/// Number of the marker within `reach` [pixels] of a pixel; empty: none.
std::optional<std::size_t> marker_under(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
                                        const viewport::ViewportState& view, const Eigen::Vector2d& pixel,
                                        double reach) {
    const auto place = commands::pick_place(state, scene, view.camera, view.size(), pixel, reach);
    if (!place || place->marker < 0) return std::nullopt;
    return static_cast<std::size_t>(place->marker);
}

}  // namespace

bool MarkerTool::takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
                       const viewport::ViewportState& view, const Eigen::Vector2d& pixel, double reach) const {
    return marker_under(state, scene, view, pixel, reach).has_value();
}

void MarkerTool::update(const ToolView& tool, Placing& placing) {
    const commands::WorkbenchState& state = tool.context.state;
    const std::vector<commands::SceneMarker>& markers = state.scene->markers;
    const auto under = marker_under(state, tool.scene, tool.view, tool.view.mouse, tool.reach());
    const PointDrag::End end = drag_.follow(tool.view, under, [&](std::size_t) -> std::optional<Eigen::Vector3d> {
        const auto place = surface_under_mouse(tool);
        return place ? std::optional(place->point) : std::nullopt;
    });
    // Undo may have removed the marker during the drag.
    const auto held = static_cast<std::size_t>(std::max(0, drag_.point()));
    if (end != PointDrag::End::none && held < markers.size()) {
        tool.context.emit(commands::ChooseMarker{drag_.point()});
        if (end == PointDrag::End::drop) move_marker(tool.context, markers[held], *drag_.place_m());
    } else if (tool.clicked() && !under) {
        if (const auto place = surface_under_mouse(tool)) {
            add_marker(tool.context, free_marker_name(*state.scene, placing.next_name), place->point);
            // The typed name was for one marker; the next one gets a free name.
            placing.next_name.clear();
        }
    }
    const auto chosen = static_cast<std::size_t>(state.marker);
    if (chosen < markers.size() && !drag_.held()) {
        draw_place_ring(tool, markers[chosen].rest_m);
        if (ImGui::IsKeyPressed(ImGuiKey_Delete, false) && !ImGui::GetIO().WantTextInput)
            remove_marker(tool.context, markers[chosen]);
    }
    const std::string next = free_marker_name(*state.scene, placing.next_name);
    draw_hint(tool.context, tool.view,
              "Click the body for " + next +
                  (markers.empty() ? ". Esc ends." : ". Drag a marker to move it, Delete removes it, Esc ends."),
              "view/placing_hint");
}

void MarkerTool::show(viewport::DrawnScene& drawn) const {
    if (!drag_.held() || !drag_.place_m()) return;
    for (viewport::DrawnMarker& marker : drawn.markers)
        if (marker.number == drag_.point()) marker.position = *drag_.place_m();
}

bool MarkerTool::cancel() {
    const bool held = drag_.held();
    drag_.cancel();
    return held;
}

}  // namespace myo::ui::panels
