#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::dynamics {

/// One implicit stage of an integrator: find x with
///   inertia M x + dW/dx(x; rate) = constant + f_ext(t),   rate = rate_factor strain(x) + rate_history.
/// inertia = 0 is statics.
struct Stage {
    double time_s = 0.0;
    double inertia_1_s2 = 0.0;
    Eigen::Matrix3Xd constant;  // 3 x n [N]
    double rate_factor_1_s = 0.0;
    Eigen::VectorXd rate_history;  // strain_count entries [1/s], twice as many where the body creeps (see creep.hpp);
                                   // empty in statics
    Eigen::Matrix3Xd velocity_history;  // 3 x n [m/s]: v = rate_factor x + velocity_history; empty: at rest
    bool before_jump = false;           // loads and activations are taken from the left of time_s
    double inertia_at_s = 0.0;          // M is that of then: the middle of the step, away from the jumps at its ends
};

enum class SolveStatus { not_run, converged, not_converged, not_finite };

/// Where the time of a solve went [s], on the wall clock; the rest is vectors and bookkeeping.
struct SolverTimes {
    double forces_s = 0.0;
    double stiffness_s = 0.0;  // matrices of the cells and their assembly
    double factorisation_s = 0.0;
    double linear_s = 0.0;  // solves and matrix products

    SolverTimes& operator+=(const SolverTimes& other) {
        forces_s += other.forces_s;
        stiffness_s += other.stiffness_s;
        factorisation_s += other.factorisation_s;
        linear_s += other.linear_s;
        return *this;
    }
};

struct StageReport {
    SolveStatus status = SolveStatus::not_run;
    int newton_iterations = 0;  // of the strategy, quasi-Newton or not
    int linear_iterations = 0;
    int factorisations = 0;
    double residual = 0.0;  // relative to the forces on the body
    SolverTimes times;
    std::string message;

    bool ok() const { return status == SolveStatus::converged; }
};

}  // namespace myo::dynamics
