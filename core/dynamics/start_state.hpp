#pragma once

#include <Eigen/Core>

#include "dynamics/simulate.hpp"

namespace myo::dynamics {

/// Positions with the clamped nodes where the body is held.
Eigen::Matrix3Xd held_by(const model::Body& body, Eigen::Matrix3Xd x);

/// Strains and their rates at the positions and velocities of the start.
void set_start_strains(const model::Model& model, StartKind start, Kinematics& state);

/// Positions, velocities and strains at t = 0; forces are not set yet. False: there is no such start, and the trace
/// says why.
bool set_start(const SimulationOptions& options, StageSolver& solver, Kinematics& state, Trace& trace);

/// Whether the first step has to be one of implicit Euler. Forces and strains of a start without energy are forgotten:
/// implicit Euler needs none. A viscous body whose velocities would turn or strain a cell by more than half of itself
/// within h: the trapezoid would take the mean of viscous forces that turn while it does, and feed in many times the
/// energy of the motion.
bool needs_euler(const model::Model& model, double h_s, Kinematics& state);

/// Enters a solve in the run's counts.
void count(const StageReport& report, Trace& trace);

}  // namespace myo::dynamics
