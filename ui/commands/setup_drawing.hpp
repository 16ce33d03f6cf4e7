#pragma once

#include <vector>

#include "commands/scene_at_time.hpp"

namespace myo::ui::commands {

/// Adds what the experiment declares around the body: obstacles, parts, gravity, and the loads of the shown trial. The
/// item that is edited in a panel is highlighted; a load shows the box that carries it only then.
///
/// @param live  paint of the part that the brush paints, during a stroke; may be null
void add_setup(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
               const MotionSummary& motion, const fibre::CellPaint* live = nullptr);

/// Colours of parts follow those of muscles, chambers and tendons.
///
/// @param part  index in Scene::parts, or their number for a new one
const ImVec4& part_color(const WorkbenchState& state, const platform::Theme& theme, std::size_t part);

/// Points of the body at rest in the box of each load of the shown trial, as indices of the points that are drawn.
std::vector<std::vector<int>> loaded_points(const WorkbenchState& state);

/// Part of each cell at rest: the one whose box holds its middle or, given otherwise, at least half of it; of parts
/// that overlap the later one. -1: none. Empty without parts or a mesh.
std::vector<int> part_of_cell(const WorkbenchState& state);

}  // namespace myo::ui::commands
