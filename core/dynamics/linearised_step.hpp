#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "dynamics/integrator.hpp"

namespace myo::dynamics {

/// One step of an integrator as the linear map of small deviations from an equilibrium, with the body's own mass,
/// stiffness and damping. It is the integrator's step with linear stage solves. Keeps the stiffness of the stages. Not
/// to be shared between threads; the solver must outlive it.
class LinearisedStep {
public:
    /// x: an equilibrium under the loads and activations of time_s, 3 x n. The model's own velocity force is not used.
    LinearisedStep(StageSolver& solver, Eigen::Matrix3Xd x, double time_s, const TimeScheme& scheme, double h_s,
                   double velocity_force_1_s);

    /// The displacement `u` (3 x n, zero on clamped nodes) at rest, with its forces.
    Kinematics displaced(const Eigen::Matrix3Xd& u);

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

/// Growth of the slowest decaying or fastest growing deviation.
struct GrowthPerStep {
    SolveStatus status = SolveStatus::not_run;
    double spectral_radius = 0.0;
    int steps = 0;
    double residual = 0.0;  // of the two-term recurrence that a pair of conjugate roots obeys, relative
};

/// Power iteration: steps from `start` until the deviations (u, h v, h v_lag) of three steps obey y2 = a y1 + b y0,
/// whose roots are the dominant pair. Errors: not_converged after max_steps, when several modes decay alike, as under
/// the trapezoidal rule without damping.
GrowthPerStep growth_per_step(LinearisedStep& step, const Eigen::Matrix3Xd& start, int max_steps = 400);

/// Lambda at which the body's slowest vibration neither decays nor grows at step h, by the secant rule on power
/// iterations that start from its first mode. Higher modes are damped more, by every integrator and by strain rates.
/// Errors: those of natural_modes() and growth_per_step().
struct CriticalVelocityForce {
    SolveStatus status = SolveStatus::not_run;
    double velocity_force_1_s = 0.0;
    double omega_rad_s = 0.0;  // of the first mode
    int steps = 0;             // of all power iterations
};
CriticalVelocityForce critical_velocity_force(StageSolver& solver, const Eigen::Matrix3Xd& x, double time_s,
                                              const TimeScheme& scheme, double h_s);

}  // namespace myo::dynamics
