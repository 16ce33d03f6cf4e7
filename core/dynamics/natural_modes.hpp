#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// A small vibration about an equilibrium: K shape = omega^2 M shape, shape' M shape = 1.
struct NaturalMode {
    double omega_rad_s = 0.0;
    Eigen::Matrix3Xd shape;  // 3 x n [1/sqrt(kg)], zero on clamped nodes
};

struct NaturalModes {
    SolveStatus status = SolveStatus::not_run;
    int iterations = 0;
    double residual = 0.0;           // largest |K phi - omega^2 M phi| / |K phi| of the modes
    std::vector<NaturalMode> modes;  // lowest first

    bool ok() const { return status == SolveStatus::converged; }
};

/// The lowest `count` modes of the undamped body about the equilibrium x (3 x n) under the loads and activations and
/// with the mass of time_s. They are solved to a residual of 1e-7, or to where rounding ends the way
/// down, 1e-4 at most; frequencies are good to its square.
///
/// Inverse iteration of a block of vectors with a Rayleigh-Ritz step.
/// Errors: not_converged where the iteration does not settle; not_finite where K is singular, as for a body that is not
/// held. Asserts 0 < count <= unknowns. Source: Bathe 2014, sec. 11.6 (subspace iteration).
NaturalModes natural_modes(StageSolver& solver, const Eigen::Matrix3Xd& x, int count, double time_s = 0.0);

}  // namespace myo::dynamics
