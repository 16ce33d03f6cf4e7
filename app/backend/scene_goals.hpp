#pragma once

#include <vector>

#include "commands/goal_view.hpp"
#include "experiment/experiment.hpp"

namespace myo::backend {

/// Goals of a trial for display.
std::vector<ui::commands::SceneGoal> scene_goals(const experiment::Experiment& experiment,
                                                 const experiment::TrialDeclaration& trial);

}  // namespace myo::backend
