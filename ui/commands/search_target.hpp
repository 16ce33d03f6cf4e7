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

/// Whether anything has a signal that could be sought.
inline bool has_actuators(const Scene& scene, const Settings& settings) {
    return !settings.muscles.empty() || !scene.declared.chambers.empty() || !scene.declared.tendons.empty();
}

/// The request without what the experiment and the settings no longer have.
inline OptimizeRequest offered_request(const Scene& scene, const Settings& settings, OptimizeRequest request) {
    const std::vector<SeekChoice> choices = seek_choices(scene.seekable, settings);
    std::erase_if(request.seek, [&](const std::string& word) {
        return std::none_of(choices.begin(), choices.end(),
                            [&](const SeekChoice& choice) { return choice.word == word; });
    });
    request.signals = request.signals && has_actuators(scene, settings);
    return request;
}

}  // namespace myo::ui::commands
