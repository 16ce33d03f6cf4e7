#pragma once

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// The force of the diagnosis' chosen row in the shown trial, where it was worked out for the body that is shown; else
/// null.
const PatchForces* shown_forces(const WorkbenchState& state);

/// Force on each patch (3 x patches) at a time [N]; without columns outside of what is known.
Eigen::Matrix3Xd force_at_time(const PatchForces& forces, double time_s);

/// A time at which arrows of these forces can be seen: this one where they can, else that of the largest.
double time_with_forces(const PatchForces& forces, double time_s);

/// Arrows of that force at the state's time, each the sum over a patch of nodes and drawn from its middle, with their
/// scale: one for the whole trial, so that lengths can be compared in time. Sees the drawn positions; makes the body
/// translucent, as arrows start inside.
void add_force_arrows(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
