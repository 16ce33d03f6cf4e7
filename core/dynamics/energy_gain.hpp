#pragma once

#include "dynamics/kinematics.hpp"

namespace myo::dynamics {

/// Whether the energy gained in a step exceeds what loads, muscles and velocity force supply by more than 2 % of the
/// energy that is in motion. Only checked if these are constant over the step. Softening dissipates between steps;
/// therefore the stiffness of this step is used at both ends.
bool gains_energy(const StageSolver& solver, const Kinematics& from, const Kinematics& to, double from_s, double to_s);

}  // namespace myo::dynamics
