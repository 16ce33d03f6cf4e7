#include "panels/distance_tool.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels/escape.hpp"
#include "panels/view_points.hpp"

namespace myo::ui::panels {
namespace {

/// Length now and, below it, at rest with the change. Two ends at the same point at rest have no relative change.
std::string label_of(const MeasuredDistance& distance) {
    const double change = distance.now_m - distance.at_rest_m;
    // Two lines: the present length; length at rest, change, and change in per cent.
    char text[120];
    if (distance.at_rest_m > 0.0)
        std::snprintf(text, sizeof text, "%.2f mm\nat rest %.2f mm, %+.2f mm, %+.1f %%", 1e3 * distance.now_m,
                      1e3 * distance.at_rest_m, 1e3 * change, 100.0 * change / distance.at_rest_m);
    else
        std::snprintf(text, sizeof text, "%.2f mm\nat rest 0 mm", 1e3 * distance.now_m);
    return text;
}

// Dark below light, so that the line is visible on any background.
void draw_line(ImDrawList& list, const platform::Theme& theme, const ImVec2& a, const ImVec2& b) {
    const float s = theme.scale;
    const ImU32 accent = platform::packed(theme.accent), dark = IM_COL32(0, 0, 0, 160);
    list.AddLine(a, b, dark, 4.0f * s);
    list.AddLine(a, b, accent, 2.0f * s);
    for (const ImVec2& end : {a, b}) {
        list.AddCircleFilled(end, 5.0f * s, dark);
        list.AddCircleFilled(end, 3.5f * s, accent);
    }
}

}  // namespace

void measure(std::vector<MeasuredDistance>& distances, const viewport::DrawnScene& scene) {
    for (MeasuredDistance& each : distances)
        each.now_m = (commands::place_now(each.to, scene) - commands::place_now(each.from, scene)).norm();
}

void draw_distances(ImDrawList& list, const platform::Theme& theme, const std::vector<MeasuredDistance>& distances,
                    const viewport::DrawnScene& scene, const viewport::ViewportState& view) {
    const float s = theme.scale;
    for (const MeasuredDistance& each : distances) {
        const auto a = window_pixel(view, commands::place_now(each.from, scene)),
                   b = window_pixel(view, commands::place_now(each.to, scene));
        if (!a || !b) continue;
        draw_line(list, theme, *a, *b);
        const std::string label = label_of(each);
        const float width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, label.c_str()).x;
        draw_note(list, theme, {0.5f * (a->x + b->x - width), std::max(a->y, b->y) + 12.0f * s},
                  label);  // below the line, so that it stays visible
    }
}

void DistanceTool::clear() {
    distances_.clear();
    begun_.reset();
}

void DistanceTool::take_click(const PanelContext& context, const viewport::DrawnScene& scene,
                              const viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    // Markers take precedence within reach, so that distances between markers are exact.
    const auto place = commands::pick_place(state, scene, view.camera, view.size(), view.mouse,
                                            static_cast<double>(marker_reach * context.theme.scale));
    if (place && begun_)
        distances_.push_back(
            {*begun_, *place, 0.0,
             (commands::place_at_rest(*place, state) - commands::place_at_rest(*begun_, state)).norm()});
    if (place && begun_)
        begun_.reset();
    else if (place)
        begun_ = place;
}

/// A click takes the first end, the second click completes the distance. All distances are drawn in each frame, as
/// their ends move.
void DistanceTool::update(PanelContext& context, const viewport::DrawnScene& scene, viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    if (scene_ != state.scene || body_ != state.body) clear();
    scene_ = state.scene;
    body_ = state.body;
    if (view.measuring && escape_closes()) {
        // The first Escape drops the started distance, the second one ends measuring.
        if (!begun_) view.measuring = false;
        begun_.reset();
    }
    // Measuring may have been switched off by its menu entry or shortcut.
    if (!view.measuring) begun_.reset();
    if (view.measuring && view.clicked) take_click(context, scene, view);
    // For a frame the scene may still show the previous mesh.
    if (state.body && scene.positions.cols() != state.body->mesh.node_count()) return;
    measure(distances_, scene);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_distances(list, context.theme, distances_, scene, view);
    if (!view.measuring) return;
    if (begun_)
        if (const auto a = window_pixel(view, commands::place_now(*begun_, scene)))
            draw_line(list, context.theme, *a, view.hovered ? ImGui::GetIO().MousePos : *a);
    // The hint names the next click and the key that leaves the tool.
    const std::string hint = begun_ ? "Click the other end. Esc: another start."
                                    : "Click two places on the body or its markers. Esc ends.";
    draw_hint(context, view, hint, "view/distance_hint");
}

}  // namespace myo::ui::panels
