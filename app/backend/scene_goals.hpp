#pragma once

#include <vector>

#include "commands/goal_view.hpp"
#include "experiment/experiment.hpp"

namespace myo::backend {

/// Goals of a trial for display: times [s] and places [m] in the mesh frame, in the order of declaration. Their markers
/// exist, which the reader of experiments has checked.
std::vector<ui::commands::SceneGoal> scene_goals(const experiment::Experiment& experiment,
                                                 const experiment::TrialDeclaration& trial);

}  // namespace myo::backend
