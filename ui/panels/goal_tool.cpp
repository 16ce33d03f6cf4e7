#include "panels/goal_tool.hpp"

#include <imgui.h>

#include <algorithm>
#include <limits>
#include <string>

#include "commands/place_text.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/escape.hpp"
#include "panels/view_points.hpp"
#include "toml/toml_text.hpp"
#include "viewport/picking.hpp"

namespace myo::ui::panels {
namespace {

/// Where the marker of a goal is at a time in the shown run [m]; not finite if there is no run.
Eigen::Vector3d simulated_place(const commands::WorkbenchState& state, const commands::SceneGoal& goal, double time_s) {
    const commands::SimulatedTrial* const run = state.simulated_trial();
    const Eigen::VectorXd& times = state.scene_trial()->time_s;
    const auto marker = static_cast<std::size_t>(std::max(0, goal.number));
    // A run of another version of the experiment has other markers or samples.
    if (!run || marker >= run->markers.size() || times.size() == 0 || run->markers[marker].cols() != times.size())
        return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return commands::at_time(run->markers[marker], commands::place_in_time(times, time_s));
}

// Dark below light, so that the marks are visible on any background.
void draw_two_lines(ImDrawList& list, const ImVec2& a, const ImVec2& b, ImU32 color, float width) {
    list.AddLine(a, b, IM_COL32(0, 0, 0, 160), 2.0f * width);
    list.AddLine(a, b, color, width);
}

/// A cross in a ring: the mark of a goal.
void draw_cross(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, ImU32 color) {
    const float s = theme.scale, radius = 8.0f * s;
    list.AddCircle(at, radius, IM_COL32(0, 0, 0, 160), 0, 4.0f * s);
    list.AddCircle(at, radius, color, 0, 2.0f * s);
    draw_two_lines(list, {at.x - radius, at.y}, {at.x + radius, at.y}, color, 1.5f * s);
    draw_two_lines(list, {at.x, at.y - radius}, {at.x, at.y + radius}, color, 1.5f * s);
}

}  // namespace

std::optional<GoalTool::Handle> GoalTool::handle_at(const commands::WorkbenchState& state, const platform::Theme& theme,
                                                    const viewport::ViewportState& view, const Eigen::Vector2d& pixel) {
    const commands::SceneTrial* const trial = state.scene_trial();
    if (!trial) return std::nullopt;
    std::optional<Handle> nearest;
    double least = static_cast<double>(marker_reach * theme.scale);
    for (std::size_t g = 0; g < trial->goals.size(); ++g) {
        const commands::SceneGoal& goal = trial->goals[g];
        if (goal.from_file) continue;  // its places are in a file
        for (Eigen::Index k = 0; k < (goal.is_path ? goal.place_m.cols() : 1); ++k) {
            const auto seen = viewport::project(view.camera, view.size(), goal.place_m.col(k));
            if (!seen || !((seen->head<2>() - pixel).norm() <= least)) continue;
            least = (seen->head<2>() - pixel).norm();
            nearest = Handle{g, k};
        }
    }
    return nearest;
}

bool GoalTool::takes(const commands::WorkbenchState& state, const platform::Theme& theme,
                     const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const {
    // Live play, brush and measuring have the mouse first; Shift leaves the drag to the camera.
    return !state.live && state.brush.tool == commands::BrushTool::none && !view.measuring &&
           !ImGui::GetIO().KeyShift && handle_at(state, theme, view, pixel).has_value();
}

Eigen::Matrix3Xd GoalTool::places(const commands::SceneGoal& goal, std::size_t index) const {
    Eigen::Matrix3Xd places = goal.place_m;
    if (!drag_ || drag_->handle.goal != index) return places;
    if (goal.is_path && drag_->handle.point < places.cols())
        places.col(drag_->handle.point) = drag_->place_m;
    else if (!goal.is_path)
        places.colwise() = drag_->place_m;
    return places;
}

void GoalTool::press(const commands::WorkbenchState& state, const platform::Theme& theme,
                     const viewport::ViewportState& view) {
    if (!takes(state, theme, view, view.mouse)) return;
    const Handle handle = *handle_at(state, theme, view, view.mouse);
    const Eigen::Vector3d place = state.scene_trial()->goals[handle.goal].place_m.col(handle.point);
    // The offset keeps the goal in place although the mouse is not exactly on it.
    drag_ = Drag{handle, place - viewport::in_image_plane(view.camera, view.size(), view.mouse, place), place};
}

void GoalTool::release(PanelContext& context) {
    const commands::SceneTrial& trial = *context.state.scene_trial();
    const Handle handle = drag_->handle;
    // Undo or another trial may have removed the goal during the drag.
    if (drag_->moved && handle.goal < trial.goals.size()) {
        const commands::SceneGoal& goal = trial.goals[handle.goal];
        const Eigen::Matrix3Xd moved = places(goal, handle.goal);
        toml::TomlPath path{"trial", static_cast<std::size_t>(context.state.trial), "goal", handle.goal};
        path.emplace_back(goal.is_path ? "places_m" : "place_m");
        const std::string text = goal.is_path ? toml::toml_list(moved.colwise(), commands::place_text)
                                              : commands::place_text(drag_->place_m);
        context.emit(commands::EditDeclaration{{commands::SetDeclared{std::move(path), text}}, "goal/drag"});
    }
    drag_.reset();
}

void GoalTool::update(PanelContext& context, const viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    const bool held = view.tool_held, pressed = held && !was_held_;
    was_held_ = held;
    if (!state.scene_trial()) {
        drag_.reset();
        return;
    }
    // The press only takes the goal; it moves from the next frame on.
    if (pressed) press(state, context.theme, view);
    if (drag_ && held && !pressed) {
        const Eigen::Vector3d place = viewport::in_image_plane(view.camera, view.size(), view.mouse, drag_->place_m) +
                                      drag_->offset_m;
        drag_->moved = drag_->moved || place != drag_->place_m;
        drag_->place_m = place;
    }
    if (drag_ && escape_closes()) drag_.reset();
    draw(context, view);
    if (drag_ && !held) release(context);
}

void GoalTool::draw(PanelContext& context, const viewport::ViewportState& view) const {
    const commands::SceneTrial& trial = *context.state.scene_trial();
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = platform::packed(theme.accent);
    for (std::size_t g = 0; g < trial.goals.size(); ++g) {
        const commands::SceneGoal& goal = trial.goals[g];
        const Eigen::Matrix3Xd at = places(goal, g);
        for (Eigen::Index k = 1; goal.is_path && k < at.cols(); ++k) {
            const auto a = window_pixel(view, at.col(k - 1)), b = window_pixel(view, at.col(k));
            if (a && b) draw_two_lines(list, *a, *b, color, 1.0f * theme.scale);
            if (b && !goal.from_file) list.AddCircleFilled(*b, 3.5f * theme.scale, color);
        }
        // The place for the shown time, within the span of the goal. The line to it is the distance that remains in the
        // shown run.
        const double time_s = std::clamp(context.state.time_s, goal.time_s(0), goal.time_s(goal.time_s.size() - 1));
        const Eigen::Vector3d place = commands::at_time(at, commands::place_in_time(goal.time_s, time_s));
        const auto end = window_pixel(view, place);
        if (!end) continue;
        if (const auto from = window_pixel(view, simulated_place(context.state, goal, time_s)))
            draw_two_lines(list, *from, *end, platform::packed(theme.failure), 1.5f * theme.scale);
        draw_cross(list, theme, *end, color);
        const ImVec2 reach{10.0f * theme.scale, 10.0f * theme.scale};
        context.items.add("view/goal/" + std::to_string(g),
                          {{end->x - reach.x, end->y - reach.y}, {end->x + reach.x, end->y + reach.y}});
    }
}

}  // namespace myo::ui::panels
