#pragma once

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// Rest under gravity, the loads and the activations just before `time_s`. x: start value in, equilibrium out.
///
/// Tries Newton directly; where it fails, follows an overdamped motion with growing steps to the equilibrium.
///
/// Of a body that softens: the virgin body brought there, whose factors are those of its own energy; the solver is left
/// with them. Errors: the report's; factors that do not come to rest.
StageReport solve_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x);

/// The stage that solve_equilibrium solves: no inertia, loads from the left of time_s.
Stage static_stage(const model::Body& body, double time_s);

}  // namespace myo::dynamics
