#include "panels/distance_tool.hpp"

#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "panels/view_points.hpp"

namespace myo {
namespace {

std::string label_of(const MeasuredDistance& distance) {
    const double change = distance.now_m - distance.at_rest_m;
    char text[120];
    if (distance.at_rest_m > 0.0) std::snprintf(text, sizeof text, "%.2f mm\nat rest %.2f mm, %+.2f mm, %+.1f %%", 1e3 * distance.now_m, 1e3 * distance.at_rest_m, 1e3 * change, 100.0 * change / distance.at_rest_m);
    else std::snprintf(text, sizeof text, "%.2f mm\nat rest 0 mm", 1e3 * distance.now_m);
    return text;
}

}  // namespace

void DistanceTool::clear() {
    distances_.clear();
    begun_.reset();
}

void DistanceTool::update(PanelContext& context, const DrawnScene& scene, ViewportState& view) {
    const WorkbenchState& state = context.state;
    if (scene_ != state.scene || body_ != state.body) clear();
    scene_ = state.scene;
    body_ = state.body;
    if (view.measuring && escape_pressed()) {
        if (!begun_) view.measuring = false;
        begun_.reset();
    }
    if (!view.measuring) begun_.reset();
    if (view.measuring && view.clicked) {
        const auto place = pick_place(state, scene, view.camera, view.size(), view.mouse, static_cast<double>(marker_reach * context.theme.scale));
        if (place && begun_) distances_.push_back({*begun_, *place, 0.0, (place_at_rest(*place, state) - place_at_rest(*begun_, state)).norm()});
        if (place && begun_) begun_.reset();
        else if (place) begun_ = place;
    }
    // The scene may still show the body before this one.
    if (state.body && scene.positions.cols() != state.body->mesh.node_count()) return;
    for (MeasuredDistance& each : distances_) each.now_m = (place_now(each.to, scene) - place_now(each.from, scene)).norm();
    draw(context, scene, view);
}

void DistanceTool::draw(PanelContext& context, const DrawnScene& scene, const ViewportState& view) const {
    const Theme& theme = context.theme;
    const float s = theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 accent = packed(theme.accent), dark = IM_COL32(0, 0, 0, 160);
    const auto line = [&](const ImVec2& a, const ImVec2& b) {
        list.AddLine(a, b, dark, 4.0f * s);
        list.AddLine(a, b, accent, 2.0f * s);
        for (const ImVec2& end : {a, b}) {
            list.AddCircleFilled(end, 5.0f * s, dark);
            list.AddCircleFilled(end, 3.5f * s, accent);
        }
    };
    for (const MeasuredDistance& each : distances_) {
        const auto a = window_pixel(view, place_now(each.from, scene)), b = window_pixel(view, place_now(each.to, scene));
        if (!a || !b) continue;
        line(*a, *b);
        draw_note(theme, {0.5f * (a->x + b->x) + 10.0f * s, 0.5f * (a->y + b->y) + 8.0f * s}, label_of(each));
    }
    if (!view.measuring) return;
    if (begun_)
        if (const auto a = window_pixel(view, place_now(*begun_, scene))) line(*a, view.hovered ? ImGui::GetIO().MousePos : *a);
    const std::string hint = begun_ ? "Click the other end. Esc: another start." : "Click two places on the body or its markers. Esc ends.";
    draw_hint(context, view, hint, "view/distance_hint");
}

}  // namespace myo
