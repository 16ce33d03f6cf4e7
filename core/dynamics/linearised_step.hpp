#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "dynamics/integrator.hpp"

namespace myo::dynamics {

/// One step of an integrator, linearised about an equilibrium: the linear map of small deviations (u, v, ...).
///
/// It is the integrator's own step with linear stage solves and the mass, stiffness and damping of the body, so that
/// its stability bounds are those of the runs. The stiffness matrices of the stages are cached. Not thread-safe; the
/// solver must outlive the object.
class LinearisedStep {
public:
    /// @param x       equilibrium under the loads and activations of `time_s`, 3 x n [m]
    /// @param h_s     length of the step [s]
    /// @param velocity_force_1_s  Lambda of the step; replaces the model's own velocity force
    LinearisedStep(StageSolver& solver, Eigen::Matrix3Xd x, double time_s, const TimeScheme& scheme, double h_s,
                   double velocity_force_1_s);

    /// Initial deviation: displacement `u` (3 x n [m], zero on clamped nodes) with zero velocity and the elastic
    /// forces.
    Kinematics displaced(const Eigen::Matrix3Xd& u);

    /// Deviation after one step.
    Kinematics apply(const Kinematics& deviation);

    const StageSolver& solver() const { return *solver_; }
    double h_s() const { return h_s_; }

private:
    struct LinearStage {
        Stage stage;  // at rest, with its inertia and rate factor
        solver::SymmetricSparse hessian;
    };
    const LinearStage& linear_stage(const Stage& stage);

    StageSolver* solver_;
    Eigen::Matrix3Xd x_;
    double time_s_;
    TimeScheme scheme_;
    double h_s_;
    double velocity_force_1_s_;
    std::vector<LinearStage> stages_;
};

/// Growth rate of the dominant deviation (slowest decay or fastest growth).
struct GrowthPerStep {
    SolveStatus status = SolveStatus::not_run;
    double spectral_radius = 0.0;  // |z| of the dominant pair of roots, per step
    int steps = 0;                 // taken until convergence
    double residual = 0.0;         // relative, of the two-term recurrence of a conjugate pair
};

/// Power iteration for the dominant pair of eigenvalues of a step.
///
/// Takes steps from `start` (displacement, 3 x n) until the deviations (u, h v, h v_lag) of three successive steps
/// satisfy y2 = a y1 + b y0; the roots of z^2 = a z + b are the dominant pair.
/// Errors: not_converged after `max_steps` if several modes decay at the same rate, as under the trapezoidal rule
/// without damping; not_finite if the deviation overflows or vanishes.
GrowthPerStep growth_per_step(LinearisedStep& step, const Eigen::Matrix3Xd& start, int max_steps = 400);

/// Critical velocity force: Lambda at which the slowest vibration of the body neither decays nor grows with step h.
struct CriticalVelocityForce {
    SolveStatus status = SolveStatus::not_run;
    double velocity_force_1_s = 0.0;  // Lambda at the stability limit
    double omega_rad_s = 0.0;         // of the first mode
    int steps = 0;                    // of all power iterations
};
/// Secant method on power iterations that start from the first mode. Higher modes need not be considered: every
/// integrator and strain-rate damping damp them more.
///
/// @param x  equilibrium, 3 x n [m]
/// Errors: those of natural_modes() and growth_per_step().
CriticalVelocityForce critical_velocity_force(StageSolver& solver, const Eigen::Matrix3Xd& x, double time_s,
                                              const TimeScheme& scheme, double h_s);

}  // namespace myo::dynamics
