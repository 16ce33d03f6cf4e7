#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// Small vibration about an equilibrium: K shape = omega^2 M shape, shape' M shape = 1.
struct NaturalMode {
    double omega_rad_s = 0.0;
    Eigen::Matrix3Xd shape;  // 3 x n [1/sqrt(kg)], zero on clamped nodes
};

/// Result of natural_modes().
struct NaturalModes {
    SolveStatus status = SolveStatus::not_run;  // not_converged, not_finite: no modes
    int iterations = 0;
    double residual = 0.0;           // largest |K phi - omega^2 M phi| / |K phi| over the modes
    std::vector<NaturalMode> modes;  // lowest first

    bool ok() const { return status == SolveStatus::converged; }
};

/// Lowest `count` modes of the undamped body about the equilibrium x.
///
/// Subspace iteration: inverse iteration of a block of vectors with a Rayleigh-Ritz projection. It stops at a residual
/// of 1e-7, or at up to 1e-4 if rounding prevents a further decrease. The relative error of a frequency is of the order
/// of the residual squared.
/// @param x       equilibrium under the loads, activations and mass of `time_s`, 3 x n [m]
/// @param count   0 < count <= unknowns (asserted)
/// Errors: not_converged if the iteration stalls; not_finite if K is singular, e.g. for a body without supports.
/// Source: Bathe 2014, sec. 11.6 (subspace iteration).
NaturalModes natural_modes(StageSolver& solver, const Eigen::Matrix3Xd& x, int count, double time_s = 0.0);

}  // namespace myo::dynamics
