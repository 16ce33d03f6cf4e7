#pragma once

#include <algorithm>
#include <string>

#include "commands/backend.hpp"

// What Optimise follows in a trial: its goals, or else its recording.

namespace myo::ui::commands {

/// Whether signals can be sought for a trial: it has goals or measured markers.
inline bool has_target(const SceneTrial& trial) {
    return !trial.goals.empty() || (trial.role != "simulate" && !trial.measured.empty());
}

/// Whether any trial has goals.
inline bool any_goals(const Scene& scene) {
    return std::any_of(scene.trials.begin(), scene.trials.end(),
                       [](const SceneTrial& trial) { return !trial.goals.empty(); });
}

/// "2 goals of reach" or "recording of release".
inline std::string target_words(const SceneTrial& trial) {
    const std::size_t goals = trial.goals.size();
    const std::string what = goals == 0 ? "recording" : std::to_string(goals) + (goals == 1 ? " goal" : " goals");
    return what + " of " + trial.name;
}

}  // namespace myo::ui::commands
