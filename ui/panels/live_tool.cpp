#include "panels/live_tool.hpp"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "base/markup.hpp"
#include "commands/picked_place.hpp"
#include "panels/view_points.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// The nodes of the surface around the point that was hit, nearer ones with larger shares: 1 - (d / reach)^2 at the
/// distance d, scaled to the sum 1.
///
/// @param point_m  the point now, in the frame of the mesh
commands::LiveGrip grip_at(const viewport::DrawnScene& scene, const viewport::SurfaceHit& hit,
                           const Eigen::Vector3d& point_m) {
    commands::LiveGrip grip;
    const double reach = commands::live_play_policy.hand_share * scene.extent.size().norm();
    // Each node once, as it is a corner of several triangles.
    std::vector<int> nodes = scene.surface->corners;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<double> shares;
    const auto take = [&](int node, double share) {
        grip.nodes.push_back(node);
        shares.push_back(share);
    };
    for (const int node : nodes) {
        const double distance = (scene.positions.col(node) - point_m).norm() / reach;
        if (distance < 1.0) take(node, 1.0 - distance * distance);
    }
    // On a coarse mesh no node may be near: the triangle's corners then carry the force, none of them with share zero.
    for (int k = 0; k < 3 && grip.nodes.size() < 3; ++k)
        take(scene.surface->corners[static_cast<std::size_t>(3 * hit.triangle + k)], 1e-3 + hit.weights[k]);
    grip.shares = Eigen::Map<const Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size()));
    grip.shares /= grip.shares.sum();
    grip.offsets_m = scene.positions(Eigen::all, grip.nodes).colwise() - point_m;
    return grip;
}

/// How the play goes: time, step, and whether it keeps up with real time; otherwise what it waits for.
std::string rate_text(const commands::LiveView& live) {
    if (!live.problem.empty()) return "Live playing stands still: " + live.problem;
    if (!live.ready) return "Preparing the model\xe2\x80\xa6";
    std::string text = "Live  " + fixed_decimals(live.frame->time_s, 1) +
                       " s  \xc2\xb7  h = " + plot::value_label(1e3 * live.frame->step_s, 3) + " ms";
    if (live.rate > 0.0 && live.rate < commands::live_play_policy.behind_below)
        text += "  \xc2\xb7  behind: " + plot::value_label(live.rate, 2) + "\xc3\x97 real time";
    else
        text += "  \xc2\xb7  real time";
    return text;
}

/// The spring from the body to the mouse, with its force.
void draw_spring(PanelContext& context, const viewport::ViewportState& view, const commands::LiveFrame& frame,
                 const Eigen::Vector3d& hand_m) {
    // One end is on the body, as the model has it; the other is where the mouse is now.
    const auto from = window_pixel(view, frame.pulled_m), to = window_pixel(view, hand_m);
    if (!from || !to) return;
    const float s = context.theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 accent = platform::packed(context.theme.accent), dark = IM_COL32(0, 0, 0, 160);
    list.AddLine(*from, *to, dark, 4.0f * s);
    list.AddLine(*from, *to, accent, 2.0f * s);
    for (const ImVec2& end : {*from, *to}) {
        list.AddCircleFilled(end, 5.5f * s, dark);
        list.AddCircleFilled(end, 4.0f * s, accent);
    }
    // The force stands at the mouse, where the user looks.
    draw_note(list, context.theme, {to->x + 12.0f * s, to->y + 8.0f * s}, plot::value_label(frame.force_N, 2) + " N");
    context.items.add("view/live_force", {{to->x - 4.0f * s, to->y - 4.0f * s}, {to->x + 4.0f * s, to->y + 4.0f * s}});
}

}  // namespace

bool LiveTool::takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
                     const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const {
    return state.live && state.live->ready && !ImGui::GetIO().KeyShift &&
           commands::hit_on_body(state, scene, view.camera, view.size(), pixel);
}

void LiveTool::pull(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view) {
    if (!grip_) {
        const auto hit = commands::hit_on_body(context.state, scene, view.camera, view.size(), view.mouse);
        if (!hit) return;
        // The plane stays where the pull began, so that the depth of the hand does not drift.
        plane_point_m_ = hit->place(*scene.surface, scene.positions);
        grip_ = grip_at(scene, *hit, plane_point_m_);
    }
    grip_->place_m = viewport::in_image_plane(view.camera, view.size(), view.mouse, plane_point_m_);
    commands::LiveControls controls = context.state.live->controls;
    controls.grip = grip_;
    context.emit(commands::SteerLive{controls});
}

void LiveTool::release(PanelContext& context) {
    grip_.reset();
    if (!context.state.live || !context.state.live->controls.grip) return;
    commands::LiveControls controls = context.state.live->controls;
    controls.grip.reset();
    context.emit(commands::SteerLive{controls});
}

void LiveTool::update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                      bool placing) {
    const commands::WorkbenchState& state = context.state;
    // A drag that began elsewhere must not take the body when it passes over it.
    const bool held = view.tool_held && !placing && state.live && state.live->ready;
    if (held && (grip_ || !was_held_))
        pull(context, scene, view);
    else if (!held && grip_)
        release(context);
    was_held_ = held;
    if (!state.live || placing) return;
    draw_hint(context, view,
              rate_text(*state.live) + (state.live->ready && !grip_ ? "  \xc2\xb7  drag the body to pull it" : ""),
              "view/live");
    if (state.live->frame && grip_ && state.live->controls.grip)
        draw_spring(context, view, *state.live->frame, grip_->place_m);
}

}  // namespace myo::ui::panels
