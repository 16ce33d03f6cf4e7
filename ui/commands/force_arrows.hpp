#pragma once

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Forces of the selected diagnosis row in the shown trial. Null if there are none, or if they were computed for
/// another mesh than the shown one.
const PatchForces* shown_forces(const WorkbenchState& state);

/// Force on each patch at a time, 3 x patches [N], interpolated between samples. No columns if there are no samples.
Eigen::Matrix3Xd force_at_time(const PatchForces& forces, double time_s);

/// A time [s] at which arrows of these forces are visible: `time_s` if they are visible there, otherwise the time of
/// the largest force.
double time_with_forces(const PatchForces& forces, double time_s);

/// Adds force arrows at the state's time to a drawn scene, and their scale. Does nothing if no forces are shown.
///
/// Each arrow is the sum over a patch of nodes and starts at its centre. One scale holds for the whole trial, so that
/// lengths can be compared over time. Requires drawn.positions; makes the body translucent, as arrows start inside it.
void add_force_arrows(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
