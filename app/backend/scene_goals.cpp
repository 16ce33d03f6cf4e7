#include "backend/scene_goals.hpp"

#include <algorithm>

namespace myo::backend {

std::vector<ui::commands::SceneGoal> scene_goals(const experiment::Experiment& experiment,
                                                 const experiment::TrialDeclaration& trial) {
    std::vector<ui::commands::SceneGoal> goals;
    for (const experiment::GoalDeclaration& goal : trial.goals) {
        const auto& markers = experiment.markers.on_body;
        const auto found = std::find_if(
            markers.begin(), markers.end(),
            [&](const experiment::MarkerDeclaration& marker) { return marker.name == goal.marker; });
        goals.push_back({goal.marker, static_cast<int>(found - markers.begin()), goal.times_s, goal.places_m,
                         goal.weight, goal.is_path, goal.file.has_value(), goal.axes});
    }
    return goals;
}

}  // namespace myo::backend
