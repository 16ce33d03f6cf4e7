#pragma once

#include <vector>

#include "commands/scene_support.hpp"
#include "experiment/experiment.hpp"

namespace myo::backend {

/// Supports of a declaration besides the clamp, as the window shows them: box [m] and the axes that are held.
ui::commands::SceneSupports shown_supports(const experiment::Experiment& experiment);

/// Boxes whose faces a mesh meets: those of clamp, supports and parts [m].
std::vector<Box> mesh_boxes(const experiment::Experiment& experiment);

}  // namespace myo::backend
