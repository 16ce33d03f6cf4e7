#pragma once

#include <Eigen/Core>

#include "dynamics/simulate.hpp"

namespace myo::dynamics {

/// Positions x with clamped nodes, and guided ones along their held axes, at their rest positions. 3 x n [m].
Eigen::Matrix3Xd held_by(const model::Body& body, Eigen::Matrix3Xd x);

/// Sets strain and rate of a state from its positions and velocities. `start` decides whether dashpots are relaxed.
void set_start_strains(const model::Model& model, StartKind start, Kinematics& state);

/// Sets positions, velocities and strains at t = 0; forces are not set yet.
///
/// Returns false if there is no such start (non-finite values, no equilibrium); the trace then holds the message.
bool set_start(const SimulationOptions& options, StageSolver& solver, Kinematics& state, Trace& trace);

/// Whether the first step must be implicit Euler, which uses no initial force.
///
/// True in two cases. (1) Force or strain of the start state is not finite: they are set to those of the rest shape.
/// (2) The velocities would strain or rotate a cell of a viscous body by more than half within h: the trapezoidal stage
/// averages viscous forces that rotate during the step, and would add many times the kinetic energy.
bool needs_euler(const model::Model& model, double h_s, Kinematics& state);

/// Adds the counts and times of a solve to those of the run.
void count(const StageReport& report, Trace& trace);

}  // namespace myo::dynamics
