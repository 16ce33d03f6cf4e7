#include "panels/inspect_tool.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "mesh/cell_topology.hpp"
#include "panels/escape.hpp"
#include "panels/view_points.hpp"

namespace myo::ui::panels {
namespace {

/// Draws the edges of a cell over the view. `edges` lists pairs of corner numbers.
template <class Edges>
void draw_edges(ImDrawList& list, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                const Eigen::VectorXi& cell, const Edges& edges, ImU32 color, float width) {
    for (const auto& edge : edges) {
        const auto a = window_pixel(view, scene.positions.col(cell[edge[0]])),
                   b = window_pixel(view, scene.positions.col(cell[edge[1]]));
        if (a && b) list.AddLine(*a, *b, color, width);
    }
}

}  // namespace

/// The card stays open while the motion plays, and its values follow the shown time.
void InspectTool::update(PanelContext& context, const viewport::DrawnScene& scene,
                         const viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    // A place belongs to a mesh; its node numbers mean nothing on another one.
    if (scene_ != state.scene || body_ != state.body) picked_.reset();
    scene_ = state.scene;
    body_ = state.body;
    // A click on the card must not pick what lies behind it.
    const bool on_card = picked_ && card_.contains(ImGui::GetIO().MousePos);
    if (view.clicked && !view.measuring && state.brush.tool == commands::BrushTool::none && !on_card)
        click(context, scene, view);
    if (escape_closes()) picked_.reset();
    // While a new mesh replaces the old one, the drawn body is still the old one for a frame.
    if (!picked_ || (picked_->marker < 0 && scene.positions.cols() != state.body->mesh.node_count())) return;
    draw_highlight(context, scene, view);
    draw_card(context, scene, view);
}

void InspectTool::click(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view) {
    const double reach = static_cast<double>(marker_reach * context.theme.scale);
    picked_ = commands::pick_place(context.state, scene, view.camera, view.size(), view.mouse, reach);
    // View and plots always show the same marker.
    if (picked_ && picked_->marker >= 0) context.emit(commands::ChooseMarker{picked_->marker});
}

const commands::MarkerError* InspectTool::error_of(const commands::WorkbenchState& state) {
    const commands::SceneTrial* const trial = state.scene_trial();
    if (!trial || picked_->marker < 0) return nullptr;
    if (const auto run = state.shown_run();
        // Errors of all markers take a pass over the run, so they are kept until trial or run change.
        run_ != run || trial_ != state.trial || errors_.size() != state.scene->markers.size()) {
        errors_ = commands::marker_errors(*state.scene, *trial, state.simulated_trial());
        run_ = run;
        trial_ = state.trial;
    }
    const auto m = static_cast<std::size_t>(picked_->marker);
    return m < errors_.size() ? &errors_[m] : nullptr;
}

/// A marker gets a ring; a place on the body gets the edges of its cell and the nearest node, whose field value the
/// card shows.
void InspectTool::draw_highlight(const PanelContext& context, const viewport::DrawnScene& scene,
                                 const viewport::ViewportState& view) const {
    const float s = context.theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 accent = platform::packed(context.theme.accent), dark = IM_COL32(0, 0, 0, 160);
    if (picked_->marker >= 0) {
        if (const auto at = window_pixel(view, commands::place_now(*picked_, scene))) {
            list.AddCircle(*at, 11.0f * s, dark, 0, 4.0f * s);
            list.AddCircle(*at, 11.0f * s, accent, 0, 2.0f * s);
        }
        return;
    }
    const mesh::VolumeMesh& mesh = context.state.body->mesh;
    const Eigen::VectorXi cell = mesh.cells.col(picked_->cell);
    // A dark line below the bright one keeps the edges visible on any background.
    for (const auto& [color, width] : {std::pair{dark, 3.5f * s}, std::pair{accent, 1.8f * s}}) {
        // Quadratic tetrahedra are marked by their straight edges, which suffices to find them.
        if (mesh.type == mesh::CellType::hex8)
            draw_edges(list, scene, view, cell, mesh::hexahedron_edges, color, width);
        else
            draw_edges(list, scene, view, cell, mesh::tetrahedron_edges, color, width);
    }
    if (const auto at = window_pixel(view, scene.positions.col(picked_->node))) {
        list.AddCircleFilled(*at, 5.5f * s, dark);
        list.AddCircleFilled(*at, 4.0f * s, accent);
    }
}

void InspectTool::draw_card(PanelContext& context, const viewport::DrawnScene& scene,
                            const viewport::ViewportState& view) {
    const std::vector<commands::ReportLine> lines = commands::lines_about(*picked_, context.state, scene,
                                                                          error_of(context.state));
    const float s = context.theme.scale, margin = 10.0f * s, line = ImGui::GetTextLineHeight() + 3.0f * s;
    // Two columns as wide as their longest text.
    float labels = 0.0f, values = 0.0f;
    for (const commands::ReportLine& each : lines) {
        labels = std::max(labels, ImGui::CalcTextSize(each.label.c_str()).x);
        values = std::max(values, ImGui::CalcTextSize(each.value.c_str()).x);
    }
    // 14 pixels at scale 1 separate labels and values.
    const float width = labels + 14.0f * s + values + 2.0f * margin;
    // Left of the legend of a field, below the buttons.
    const float right = view.pixels.highest.x - (scene.field ? 90.0f : 12.0f) * s;
    const ImVec2 from{std::max(view.pixels.lowest.x + 4.0f * s, right - width), view.pixels.lowest.y + 52.0f * s};
    card_ = {from, {from.x + width, from.y + line * static_cast<float>(lines.size()) + 2.0f * margin}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(card_.lowest, card_.highest, platform::packed(context.theme.popup, 0.94f), 6.0f * s);
    list.AddRect(card_.lowest, card_.highest, platform::packed(context.theme.border), 6.0f * s);
    float y = from.y + margin;
    for (const commands::ReportLine& each : lines) {
        list.AddText({from.x + margin, y}, platform::packed(context.theme.muted), each.label.c_str());
        list.AddText({from.x + margin + labels + 14.0f * s, y}, platform::packed(context.theme.text),
                     each.value.c_str());
        y += line;
    }
    context.items.add("view/inspector", card_);
}

}  // namespace myo::ui::panels
