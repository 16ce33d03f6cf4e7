#pragma once

#include <string>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// Static equilibrium under gravity, loads and activations just before `time_s`.
///
/// Tries Newton's method first; if it fails, raises pressures and other commands of force elements in steps, then
/// follows an overdamped motion with growing steps to the equilibrium. A
/// softening body is loaded from its virgin state, with softening factors consistent with its own energy; the solver
/// keeps these factors.
/// @param x  in: initial guess; out: equilibrium. 3 x n [m]
/// Errors: those of the report, or softening factors that do not converge. If commands have no equilibrium, the message
///         names them and the values at which none was found.
StageReport solve_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x);

/// Message: no equilibrium was found under this part of the commands.
std::string collapse_words(const model::Model& model, double part, double time_s);

/// Adds the counts and times of an earlier solve to a report.
void add_work(const StageReport& before, StageReport& report);

/// The stage that solve_equilibrium() solves: no inertia, loads from the left of `time_s`.
Stage static_stage(const model::Body& body, double time_s);

}  // namespace myo::dynamics
