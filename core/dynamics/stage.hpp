#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::dynamics {

/// One implicit stage of an integrator: find x with
///   inertia M x + dW/dx(x; rate) = constant + f_ext(t),   rate = rate_factor strain(x) + rate_history.
/// With inertia = 0 this is a static problem.
struct Stage {
    double time_s = 0.0;                // time of loads and activations
    double inertia_1_s2 = 0.0;          // factor of the mass matrix
    Eigen::Matrix3Xd constant;          // 3 x n [N]
    double rate_factor_1_s = 0.0;       // f: strain rate = f strain + rate_history
    Eigen::VectorXd rate_history;       // [1/s], one entry per strain measure, two with creep (see creep.hpp); empty in
                                        // statics
    Eigen::Matrix3Xd velocity_history;  // 3 x n [m/s]: v = rate_factor x + velocity_history; empty: v = 0
    bool before_jump = false;           // take loads and activations from the left of time_s
    double inertia_at_s = 0.0;          // instant of M: the middle of the step, away from jumps at its ends
};

/// Outcome of an iterative solution.
enum class SolveStatus { not_run, converged, not_converged, not_finite };

/// Wall-clock times of the parts of a solve [s]. The remainder is vector operations and bookkeeping.
struct SolverTimes {
    double forces_s = 0.0;     // potential and residual
    double stiffness_s = 0.0;  // cell matrices and assembly
    double factorisation_s = 0.0;
    double linear_s = 0.0;  // triangular solves and matrix products

    SolverTimes& operator+=(const SolverTimes& other) {
        forces_s += other.forces_s;
        stiffness_s += other.stiffness_s;
        factorisation_s += other.factorisation_s;
        linear_s += other.linear_s;
        return *this;
    }
};

/// Outcome of a stage solve.
struct StageReport {
    SolveStatus status = SolveStatus::not_run;
    int newton_iterations = 0;  // of the chosen strategy, also quasi-Newton ones
    int linear_iterations = 0;  // of conjugate gradients
    int factorisations = 0;
    double residual = 0.0;  // relative to StageProblem::force_scale()
    SolverTimes times;
    std::string message;  // reason of a failure

    bool ok() const { return status == SolveStatus::converged; }
};

}  // namespace myo::dynamics
