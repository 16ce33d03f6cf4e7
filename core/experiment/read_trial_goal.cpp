#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "measurement/trace_csv.hpp"

namespace myo::experiment {
namespace {

/// Coordinates that count, from axes = ["x", "z"].
std::array<bool, 3> read_goal_axes(const toml::TomlReader& table) {
    std::array<bool, 3> axes{false, false, false};
    for (const std::string& word : table.texts("axes")) {
        const std::size_t axis = std::string("xyz").find(word);
        if (word.size() != 1 || axis > 2 || axes[axis])
            table.fail("axes", "must name x, y and z at most once each, for example [\"x\", \"z\"]");
        axes[axis] = true;
    }
    if (axes == std::array<bool, 3>{false, false, false}) table.fail("axes", "must name at least one of x, y and z");
    return axes;
}

/// One place, at a time or until another [s]. A hold has no times: its goal is at t = 0.
void read_goal_place(const toml::TomlReader& table, bool hold, GoalDeclaration& goal) {
    for (const char* key : {"times_s", "places_m"})
        table.reject(key, "belongs to a path, and place_m is a single place");
    const Eigen::Vector3d place = table.vector3("place_m");
    if (hold)
        for (const char* key : {"time_s", "until_s"}) table.reject(key, "does not belong to a hold, which is one pose");
    const double time_s = hold ? 0.0 : table.number("time_s", toml::not_negative());
    const std::optional<double> until_s = table.optional_number("until_s", toml::not_negative());
    if (until_s && !(*until_s > time_s))
        table.fail("until_s", "must lie after time_s (" + format_number(time_s) + " s)");
    // A span is a path of two equal places, so that place_at() serves both.
    goal.times_s = Eigen::VectorXd::Constant(until_s ? 2 : 1, time_s);
    if (until_s) goal.times_s(1) = *until_s;
    goal.places_m = place.replicate(1, goal.times_s.size());
}

/// The path of the goal's marker in a csv trace, which may hold other markers as well.
void read_goal_file(const toml::TomlReader& table, const std::filesystem::path& folder, GoalDeclaration& goal) {
    goal.file = table.file("path", folder);
    const Result<measurement::Recording> read = measurement::read_trace_csv(*goal.file);
    if (!read) throw toml::TomlFailure{Error{table.path_of("path") + ": " + read.error().what, read.error().where}};
    const auto found = std::find(read->labels.begin(), read->labels.end(), goal.marker);
    if (found == read->labels.end())
        table.fail("path", goal.file->filename().string() + " has no marker \"" + goal.marker + "\"");
    goal.times_s = read->time_s;
    goal.places_m = read->tracks[static_cast<std::size_t>(found - read->labels.begin())];
    // A gap in a goal leaves open what is asked for, unlike one in a recording.
    if (!goal.places_m.allFinite())
        table.fail("path", "has samples of \"" + goal.marker + "\" that are not numbers; leave their rows out");
}

/// A path from a file, or from lists of times and places.
void read_goal_path(const toml::TomlReader& table, const std::filesystem::path& folder, GoalDeclaration& goal) {
    goal.is_path = true;
    for (const char* key : {"time_s", "until_s"}) table.reject(key, "belongs to place_m; a path has its own times");
    if (table.has("path")) {
        for (const char* key : {"times_s", "places_m"}) table.reject(key, "cannot be given beside path");
        read_goal_file(table, folder, goal);
    } else {
        goal.places_m = table.points("places_m");
        goal.times_s = table.vector("times_s", goal.places_m.cols());
    }
    const char* const times = table.has("path") ? "path" : "times_s";
    if (goal.times_s.size() < 2) table.fail(times, "has less than two times; place_m is a goal at one time");
    for (Eigen::Index k = 1; k < goal.times_s.size(); ++k)
        if (!(goal.times_s(k) > goal.times_s(k - 1)))
            table.fail(times, "must ascend (" + format_number(goal.times_s(k)) + " s follows " +
                                  format_number(goal.times_s(k - 1)) + " s)");
    if (goal.times_s(0) < 0.0)
        table.fail(times, "must not begin before the trial (" + format_number(goal.times_s(0)) + " s)");
}

/// Whether two goals ask for one coordinate of a marker at one time. Spans that touch at an end do.
bool contradict(const GoalDeclaration& a, const GoalDeclaration& b) {
    // Closed spans meet unless one ends before the other begins.
    const bool meet = a.times_s(0) <= b.times_s(b.times_s.size() - 1) &&
                      b.times_s(0) <= a.times_s(a.times_s.size() - 1);
    bool share = false;
    for (std::size_t axis = 0; axis < 3; ++axis) share = share || (a.axes[axis] && b.axes[axis]);
    return a.marker == b.marker && meet && share;
}

/// One [[trial.goal]]; the keys that are present decide between a place and a path.
GoalDeclaration read_goal(const toml::TomlReader& table, const std::filesystem::path& folder,
                          const TrialDeclaration& trial) {
    GoalDeclaration goal;
    goal.marker = table.name("marker");
    if (table.has("place_m")) {
        table.reject("path", "cannot be given beside place_m");
        read_goal_place(table, trial.hold, goal);
    } else if (trial.hold) {
        table.fail("place_m", "required key is missing: a hold is one pose, so its goals are places");
    } else if (table.has("path") || table.has("times_s") || table.has("places_m")) {
        read_goal_path(table, folder, goal);
    } else {
        table.fail("place_m", "required key is missing: a goal has place_m, or path, or times_s and places_m");
    }
    // A simulated trial has no positions after its end. How long a recording lasts is not known yet.
    const double last_s = goal.times_s(goal.times_s.size() - 1);
    if (trial.role == TrialRole::simulate && !trial.hold && last_s > trial.duration_s)
        table.fail(goal.is_path ? (goal.file ? "path" : "times_s") : (goal.times_s.size() > 1 ? "until_s" : "time_s"),
                   format_number(last_s) + " s lies after the end of the trial (duration_s " +
                       format_number(trial.duration_s) + " s)");
    goal.weight = table.number_or("weight", goal.weight, toml::positive());
    if (table.has("axes")) goal.axes = read_goal_axes(table);
    return goal;
}

}  // namespace

std::vector<GoalDeclaration> read_goals(const toml::TomlReader& trial, const std::filesystem::path& folder,
                                        const TrialDeclaration& declared) {
    std::vector<GoalDeclaration> goals;
    for (const toml::TomlReader& table : trial.tables(
             "goal", {"marker", "place_m", "time_s", "until_s", "path", "times_s", "places_m", "weight", "axes"})) {
        goals.push_back(read_goal(table, folder, declared));
        for (std::size_t g = 0; g + 1 < goals.size(); ++g)
            if (contradict(goals[g], goals.back()))
                table.fail("marker", "\"" + goals.back().marker + "\" has another goal at the same time, goal[" +
                                         std::to_string(g) + "]");
    }
    return goals;
}

}  // namespace myo::experiment
