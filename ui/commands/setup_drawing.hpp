#pragma once

#include <vector>

#include "commands/scene_at_time.hpp"

namespace myo::ui::commands {

/// Adds what the experiment declares around the body: obstacles, parts, gravity, and the loads of the shown trial. The
/// item that is edited in a panel is highlighted; a load shows the box that carries it only then.
void add_setup(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
               const MotionSummary& motion);

/// Points of the body at rest in the box of each load of the shown trial, as indices of the points that are drawn.
std::vector<std::vector<int>> loaded_points(const WorkbenchState& state);

/// Part whose box holds the middle of each cell at rest; of parts that overlap the later one. -1: none. Empty if no
/// part is given by a box, or without a mesh.
std::vector<int> part_of_cell(const WorkbenchState& state);

}  // namespace myo::ui::commands
