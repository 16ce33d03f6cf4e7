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

void draw_note(ImDrawList& list, const Theme& theme, const ImVec2& at, const std::string& text) {
    const float s = theme.scale;
    const ImVec2 extent = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text.c_str());
    list.AddRectFilled({at.x - 5.0f * s, at.y - 3.0f * s}, {at.x + extent.x + 5.0f * s, at.y + extent.y + 3.0f * s}, packed(theme.popup, 0.92f), 4.0f * s);
    list.AddText(theme.small, theme.small->FontSize, at, packed(theme.text), text.c_str());
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
        draw_note(list, theme, {0.5f * (a->x + b->x) + 10.0f * s, 0.5f * (a->y + b->y) + 8.0f * s}, label_of(each));
    }
    if (!view.measuring) return;
    if (begun_)
        if (const auto a = window_pixel(view, place_now(*begun_, scene))) line(*a, view.hovered ? ImGui::GetIO().MousePos : *a);
    const std::string hint = begun_ ? "Click the other end. Esc: another start." : "Click two places on the body or its markers. Esc ends.";
    const ImVec2 extent = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, hint.c_str());
    const ImVec2 at{0.5f * (view.pixels.lowest.x + view.pixels.highest.x - extent.x), view.pixels.lowest.y + 56.0f * s};
    draw_note(list, theme, at, hint);
    context.items.add("view/distance_hint", {at, {at.x + extent.x, at.y + extent.y}});
}

}  // namespace myo
