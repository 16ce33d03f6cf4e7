#pragma once

#include <Eigen/Core>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// Numbers of the search for the pose of a hold.
struct HoldPolicy {
    double first_step = 0.25;         // of the commands
    double least_step = 1.0 / 128.0;  // of the commands; so exact is the part reported where the body gives way
    double growth = 2.0;              // of a step after an easy one
    int easy_iterations = 4;          // quadratic convergence needs three to five from a good prediction
    int max_iterations = 10;          // of a step; more than that and a shorter step is cheaper
    double way_tolerance = 1e-3;      // relative residual of poses under part of the commands
};
inline constexpr HoldPolicy hold_policy;

/// Static equilibrium of a hold: a pose that was reached by raising the commands of tendons and chambers.
///
/// From a similar pose Newton's method is tried at once. Otherwise the pose under gravity and loads alone is found and
/// the commands grow in steps, each predicted by a parabola through the last poses; where a pose loses its stability,
/// the potential leads to the next one. Softening bodies, and bodies whose pose without commands is hard to find, are
/// left to solve_equilibrium().
/// @param similar  pose under similar loads, 3 x n [m]; null: none
/// @param x        in: guess without commands; out: equilibrium, 3 x n [m]
/// Errors: as solve_equilibrium().
/// Source: Allgower & Georg 1990, ch. 2 (continuation by prediction and correction).
StageReport solve_hold(StageSolver& solver, double time_s, const Eigen::Matrix3Xd* similar, Eigen::Matrix3Xd& x);

}  // namespace myo::dynamics
