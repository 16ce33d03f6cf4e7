#include "panels/goal_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/place_text.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/axis_ticks.hpp"
#include "panels/declared_rows.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Rounding of places and times that the panel writes.
struct NewGoalPolicy {
    // Places and times of a new goal are rounded, so that their texts are short. The inverse of a step divides exactly.
    double steps_per_m = 1e6;
    double steps_per_s = 1e3;
};
constexpr NewGoalPolicy new_goal_policy;

/// Key of a goal of the shown trial in the declaration.
toml::TomlPath goal_path(const commands::WorkbenchState& state, std::size_t index) {
    return {"trial", static_cast<std::size_t>(state.trial), "goal", index};
}

/// `value` to a multiple of 1 / steps, in the unit of which there are `steps`.
double rounded(double value, double steps) { return std::round(value * steps) / steps; }

/// Where the chosen marker is at the shown time in the shown run [m]; at rest where there is none.
Eigen::Vector3d present_place(const commands::WorkbenchState& state) {
    const auto marker = static_cast<std::size_t>(state.marker);
    const commands::SimulatedTrial* const run = state.simulated_trial();
    const Eigen::VectorXd& times = state.scene_trial()->time_s;
    // A run of another version of the experiment has other markers or samples.
    if (run && marker < run->markers.size() && times.size() > 0 && run->markers[marker].cols() == times.size()) {
        const Eigen::Vector3d place = commands::at_time(run->markers[marker],
                                                        commands::place_in_time(times, state.time_s));
        if (place.allFinite()) return place;
    }
    return state.scene->markers[marker].rest_m;
}

/// Declaration of a goal for the chosen marker at its present place.
std::string new_goal(const commands::WorkbenchState& state) {
    const commands::SceneTrial& trial = *state.scene_trial();
    const Eigen::Vector3d place = present_place(state).unaryExpr(
        [](double x) { return rounded(x, new_goal_policy.steps_per_m); });
    std::string text = "marker = " +
                       toml::toml_text(state.scene->markers[static_cast<std::size_t>(state.marker)].name) +
                       "\nplace_m = " + commands::place_text(place) + "\n";
    // A hold is one pose without times. At the start nothing has moved yet, so the end is meant.
    const double end_s = trial.time_s.size() > 0 ? trial.time_s(trial.time_s.size() - 1) : 0.0;
    if (!(end_s > 0.0)) return text;
    const double time_s = state.time_s > 0.0 ? std::min(state.time_s, end_s) : end_s;
    return text + "time_s = " + toml::toml_number(rounded(time_s, new_goal_policy.steps_per_s)) + "\n";
}

/// Edits that give a goal these times and places, as a path, or as a single place if there is one.
std::vector<commands::DeclarationEdit> path_edits(const toml::TomlPath& goal, const Eigen::VectorXd& times_s,
                                                  const Eigen::Matrix3Xd& places_m) {
    const auto key = [&](const char* name) {
        toml::TomlPath path = goal;
        path.emplace_back(name);
        return path;
    };
    // Keys of the other form are removed: a goal with both would be refused.
    if (times_s.size() == 1)
        return {commands::RemoveDeclared{key("times_s")}, commands::RemoveDeclared{key("places_m")},
                commands::SetDeclared{key("place_m"), toml::toml_vector(places_m.col(0))},
                commands::SetDeclared{key("time_s"), toml::toml_number(times_s(0))}};
    return {commands::RemoveDeclared{key("place_m")}, commands::RemoveDeclared{key("time_s")},
            commands::RemoveDeclared{key("until_s")},
            commands::SetDeclared{key("times_s"), toml::toml_list(times_s, toml::toml_number)},
            commands::SetDeclared{key("places_m"), toml::toml_list(places_m.colwise(), toml::toml_vector)}};
}

/// Number of the point of a path at a time; -1 if there is none.
Eigen::Index point_at(const commands::SceneGoal& goal, double time_s) {
    for (Eigen::Index k = 0; k < goal.time_s.size(); ++k)
        if (std::abs(goal.time_s(k) - time_s) < 0.5 / new_goal_policy.steps_per_s) return k;
    return -1;
}

}  // namespace

void GoalPanel::draw(PanelContext& context) {
    const commands::SceneTrial& trial = *context.state.scene_trial();
    if (trial.goals.empty())
        muted_text(context.theme,
                   "A goal says where a marker shall be, and when. Optimise seeks signals that bring it there; without "
                   "goals it follows the recording.");
    for (std::size_t g = 0; g < trial.goals.size(); ++g) draw_goal(context, g);
    draw_add(context);
}

void GoalPanel::draw_number(PanelContext& context, std::size_t index, const char* key, const NumberField& field,
                            double value) {
    toml::TomlPath path = goal_path(context.state, index);
    path.emplace_back(key);
    bool goes_on = false;
    if (number_row(context, field, edits_, value, goes_on, std::to_string(context.state.trial)))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{std::move(path), toml::toml_number(value)}}, field.name, goes_on});
}

void GoalPanel::draw_goal(PanelContext& context, std::size_t index) {
    const commands::SceneGoal& goal = context.state.scene_trial()->goals[index];
    const std::string item = "goal/" + std::to_string(index);
    ImGui::PushID(static_cast<int>(index));
    const float button = ImGui::GetFrameHeight();
    row_label(context.theme, "Goal " + std::to_string(index + 1), "Where this marker shall be; drag it in the view.");
    ImGui::TextUnformatted(goal.marker.c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
    if (ImGui::Button(platform::icon::remove, {button, 0.0f}))
        context.emit(
            commands::EditDeclaration{{commands::RemoveDeclared{goal_path(context.state, index)}}, item + "/remove"});
    context.items.mark(item + "/remove");
    tooltip(context.theme, "Remove the goal");
    const Eigen::Index last = goal.time_s.size() - 1;
    // The places of a path are dragged in the view, or come from a file; only a single place has fields.
    if (goal.is_path) {
        text_row(context.theme, "Path",
                 std::to_string(last + 1) + " places from " + plot::plain_label(goal.time_s(0), 4) + " s to " +
                     plot::plain_label(goal.time_s(last), 4) + " s");
        context.items.mark(item + "/path");
    } else {
        toml::TomlPath place = goal_path(context.state, index);
        place.emplace_back("place_m");
        const NumberField field{
            "", "", commands::Dimension::length, "mm", "Coordinate in the frame of the mesh [m].", {-10.0, 10.0}, 0.05};
        vector_rows(context, {place, item + "/place"}, "Place", field, edits_, goal.place_m.col(0));
        // The only time of a hold is 0 and not declared.
        const bool timed = last > 0 || goal.time_s(0) > 0.0;
        if (timed)
            draw_number(context, index, "time_s",
                        {"Time",
                         item + "/time",
                         commands::Dimension::time,
                         "s",
                         "Time of the trial [s].",
                         {0.0, 3600.0},
                         0.005},
                        goal.time_s(0));
        // A span has an end, too: the marker shall stay at the place until then.
        if (last > 0)
            draw_number(context, index, "until_s",
                        {"Until",
                         item + "/until",
                         commands::Dimension::time,
                         "s",
                         "Time of the trial until which the marker shall stay [s].",
                         {0.0, 3600.0},
                         0.005},
                        goal.time_s(last));
    }
    draw_path_buttons(context, index);
    // What holds for every kind of goal: the coordinates that count, and its weight.
    toml::TomlPath axes = goal_path(context.state, index);
    axes.emplace_back("axes");
    axis_ticks(context, "Counts along",
               "Coordinates of the place that count; along the others the marker may be anywhere.", goal.axes, axes,
               item + "/along");
    draw_number(context, index, "weight",
                {"Weight",
                 item + "/weight",
                 commands::Dimension::number,
                 "",
                 "Weight of the squared distance to this goal, against other goals.",
                 {1e-6, 1e6},
                 0.01},
                goal.weight);
    ImGui::PopID();
}

void GoalPanel::draw_path_buttons(PanelContext& context, std::size_t index) {
    const commands::SceneGoal& goal = context.state.scene_trial()->goals[index];
    const bool is_hold = context.state.scene_trial()->time_s.size() < 2;
    // The points of a file are not in the declaration, and a hold has one pose only.
    if (goal.from_file || is_hold) return;
    const std::string item = "goal/" + std::to_string(index);
    const double time_s = rounded(context.state.time_s, new_goal_policy.steps_per_s);
    const Eigen::Index here = point_at(goal, time_s), count = goal.time_s.size();
    const toml::TomlPath path = goal_path(context.state, index);
    if (here < 0) {
        if (ImGui::Button("Add a point at the shown time", {-1.0f, 0.0f})) {
            const Eigen::Vector3d place = commands::at_time(goal.place_m, commands::place_in_time(goal.time_s, time_s));
            // A span at one place is its two ends; a single place keeps its time.
            Eigen::VectorXd times(count + 1);
            Eigen::Matrix3Xd places(3, count + 1);
            // The times of a path ascend, so the new point goes between those before and after it.
            const Eigen::Index before = (goal.time_s.array() < time_s).count();
            times << goal.time_s.head(before), time_s, goal.time_s.tail(count - before);
            places << goal.place_m.leftCols(before), place, goal.place_m.rightCols(count - before);
            context.emit(commands::EditDeclaration{path_edits(path, times, places), item + "/point"});
        }
        context.items.mark(item + "/point");
        tooltip(context.theme,
                "Makes the goal a path over time, with a point at the shown time; drag the point in the view. Between "
                "its points the path is straight.");
    } else if (goal.is_path) {
        // A path of two points becomes a single place; a single place has no point to remove.
        if (ImGui::Button("Remove the point at the shown time", {-1.0f, 0.0f})) {
            Eigen::VectorXd times(count - 1);
            Eigen::Matrix3Xd places(3, count - 1);
            times << goal.time_s.head(here), goal.time_s.tail(count - 1 - here);
            places << goal.place_m.leftCols(here), goal.place_m.rightCols(count - 1 - here);
            context.emit(commands::EditDeclaration{path_edits(path, times, places), item + "/point_removed"});
        }
        context.items.mark(item + "/point_removed");
    }
}

void GoalPanel::draw_add(PanelContext& context) {
    row_label(context.theme, "Marker", "The marker that gets the next goal.");
    ImGui::SetNextItemWidth(-1.0f);
    marker_list(context, "goal/marker");
    if (ImGui::Button("Add a goal", {-1.0f, 0.0f})) {
        // Appended to the shown trial, which also has the time and the run of the new goal.
        const toml::TomlPath array{"trial", static_cast<std::size_t>(context.state.trial), "goal"};
        context.emit(commands::EditDeclaration{{commands::AppendDeclared{array, new_goal(context.state)}}, "goal/add"});
    }
    context.items.mark("goal/add");
    tooltip(context.theme,
            "A goal for the chosen marker at the shown time, where it is in the shown run then. Move it by dragging it "
            "in the view, or by its numbers.");
}

}  // namespace myo::ui::panels
