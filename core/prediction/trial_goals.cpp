#include "prediction/trial_goals.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "measurement/recording_edit.hpp"
#include "prediction/trial_target.hpp"

namespace myo::prediction {

using Eigen::Index;
using Eigen::Matrix3Xd;

namespace {

constexpr double not_compared = std::numeric_limits<double>::quiet_NaN();

struct TrialGoalsPolicy {
    double same_time_s = 1e-9;  // sample and goal: rounding of decimal times
};
constexpr TrialGoalsPolicy trial_goals_policy;

void set_role(experiment::TrialRole role, setup::Setup& setup) {
    setup.trials.front().role = role;
    setup.experiment.trials.front().role = role;
}

/// Sample times of the trial from its start and times of the goals, ascending.
Eigen::VectorXd sample_times(const setup::PreparedTrial& trial, const std::vector<experiment::GoalDeclaration>& goals) {
    std::vector<double> times;
    for (const experiment::GoalDeclaration& goal : goals)
        times.insert(times.end(), goal.times_s.begin(), goal.times_s.end());
    const std::size_t own = times.size();
    for (const double t : trial.measured.time_s) {
        // The times of the goals are exact, those of the samples give way.
        const bool taken = std::any_of(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(own),
                                       [&](double g) { return std::abs(g - t) <= trial_goals_policy.same_time_s; });
        if (t >= 0.0 && !taken) times.push_back(t);
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Index>(times.size()));
}

/// Puts a goal into the track of its marker, and its weights.
void add_goal(const experiment::GoalDeclaration& goal, const Eigen::VectorXd& times_s, Matrix3Xd& track,
              Matrix3Xd& weights) {
    const double first = goal.times_s(0), last = goal.times_s(goal.times_s.size() - 1);
    const auto begin = std::lower_bound(times_s.begin(), times_s.end(), first) - times_s.begin();
    const auto end = std::upper_bound(times_s.begin(), times_s.end(), last) - times_s.begin();
    for (Index t = begin; t < end; ++t) {
        const Eigen::Vector3d place = experiment::place_at(goal, times_s(t));
        for (Index axis = 0; axis < 3; ++axis) {
            if (!goal.axes[static_cast<std::size_t>(axis)]) continue;
            track(axis, t) = place(axis);
            weights(axis, t) = goal.weight / static_cast<double>(end - begin);
        }
    }
}

/// Errors: a goal after the end of the runs; single coordinates, which a moving mount would mix.
Result<void> check_goals(const setup::Setup& setup) {
    const setup::PreparedTrial& trial = setup.trials.front();
    const std::vector<experiment::GoalDeclaration>& goals = setup.experiment.trials.front().goals;
    const bool mount_moves = declared_mount(setup, 0) != nullptr;
    for (std::size_t g = 0; g < goals.size(); ++g) {
        const std::string key = "trial[0].goal[" + std::to_string(g) + "]";
        const std::array<bool, 3>& axes = goals[g].axes;
        if (mount_moves && !(axes[0] && axes[1] && axes[2]))
            return experiment::declaration_error(setup.experiment, key + ".axes",
                                                 "must be left out: the mount of the trial moves");
        const double last_s = goals[g].times_s(goals[g].times_s.size() - 1);
        if (last_s > trial.options.end_s + trial_goals_policy.same_time_s)
            return experiment::declaration_error(
                setup.experiment, key,
                format_number(last_s) + " s lies after the end of trial " + trial.name + " (" +
                    format_number(trial.measured.time_s(trial.measured.time_s.size() - 1)) + " s)");
    }
    return {};
}

}  // namespace

bool follows_goals(const setup::Setup& setup) {
    return setup.trials.size() == 1 && !setup.trials.front().goal_weights.empty();
}

setup::Setup until_last_goal(setup::Setup setup) {
    if (!follows_goals(setup)) return setup;
    setup::PreparedTrial& trial = setup.trials.front();
    double last_s = 0.0;
    for (const experiment::GoalDeclaration& goal : setup.experiment.trials.front().goals)
        last_s = std::max(last_s, goal.times_s(goal.times_s.size() - 1));
    const Eigen::VectorXd& times = trial.measured.time_s;
    const auto end = std::upper_bound(times.begin(), times.end(), last_s + trial_goals_policy.same_time_s);
    const Index count = end - times.begin();
    if (count < 2) return setup;  // an interval of samples is needed for the steps
    trial.measured = measurement::slice_time(trial.measured, times(0), times(count - 1));
    for (Matrix3Xd& weights : trial.goal_weights) weights = weights.leftCols(count).eval();
    trial.options.end_s = std::min(trial.options.end_s, trial.measured.time_s(count - 1));
    return setup;
}

setup::Setup without_goals(setup::Setup setup) {
    if (!follows_goals(setup)) return setup;
    setup::PreparedTrial& trial = setup.trials.front();
    set_role(experiment::TrialRole::simulate, setup);
    for (Matrix3Xd& track : trial.measured.tracks) track.setConstant(not_compared);
    trial.occluded_fraction.assign(trial.measured.tracks.size(), 1.0);
    trial.goal_weights.clear();
    return setup;
}

Result<setup::Setup> with_goals(setup::Setup setup) {
    assert(setup.trials.size() == 1);
    const std::vector<experiment::GoalDeclaration>& goals = setup.experiment.trials.front().goals;
    if (goals.empty()) return setup;
    if (const Result<void> within = check_goals(setup); !within) return within.error();
    setup::PreparedTrial& trial = setup.trials.front();
    measurement::Recording& target = trial.measured;
    target.time_s = sample_times(trial, goals);
    target.residual_m.clear();
    target.labels = setup.marker_names;
    target.tracks.assign(setup.marker_names.size(), Matrix3Xd::Constant(3, target.time_s.size(), not_compared));
    trial.goal_weights.assign(setup.marker_names.size(), Matrix3Xd::Zero(3, target.time_s.size()));
    for (const experiment::GoalDeclaration& goal : goals) {
        const auto m = static_cast<std::size_t>(
            std::find(setup.marker_names.begin(), setup.marker_names.end(), goal.marker) - setup.marker_names.begin());
        add_goal(goal, target.time_s, target.tracks[m], trial.goal_weights[m]);
    }
    set_role(experiment::TrialRole::fit, setup);
    trial.first_sample = 0;
    trial.start_found = false;
    trial.reference_m.clear();
    trial.registration_rms_m.reset();
    trial.registration_by_places.resize(0, 0);
    trial.sensors.clear();
    setup.experiment.registration = {};
    setup.experiment.markers.compare = experiment::Comparison::position;
    return setup;
}

}  // namespace myo::prediction
