#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <string>
#include <vector>

#include "dynamics/stage_solver.hpp"

namespace myo {

/// What a one-step method carries from step to step. The same struct holds the derivative of all of it with respect to a
/// parameter: every integrator is linear in it but for the stage solves.
struct Kinematics {
    Eigen::Matrix3Xd x;          // positions, 3 x n [m]
    Eigen::Matrix3Xd v;          // velocities [m/s]
    Eigen::Matrix3Xd force;      // M times acceleration [N], zero on clamped nodes
    Eigen::VectorXd strain;      // strain measures at x
    Eigen::VectorXd rate;        // their rates [1/s]
};

enum class Integrator { tr_bdf2, implicit_euler };

std::string to_string(Integrator integrator);
std::vector<std::string> integrator_ids();
bool parse_integrator(const std::string& id, Integrator& integrator);

/// Solution of a stage: positions and strain measures there, or their derivatives.
struct StageSolution {
    Eigen::Matrix3Xd x;
    Eigen::VectorXd strain;
};

/// Everything a step needs from its surroundings besides the state. `solve` is called once per stage, in order.
/// It returns false to give up; then the step returns false too.
template <class Solve>
struct StepProblem {
    const Eigen::SparseMatrix<double>& mass;
    double time_s = 0.0;               // start of the step
    double h = 0.0;
    double velocity_force_1_s = 0.0;   // Lambda
    Solve solve;                       // bool(Stage&, StageSolution&); it may move the stage to the loads left of a jump
};

/// x1 = x0 + h v1, M (v1 - v0)/h = F(x1) + Lambda M v0, as in the paper (eqs. 3 and 10: the velocity force is the previous step's).
template <class Solve>
bool implicit_euler_step(const StepProblem<Solve>& p, const Kinematics& s, Kinematics& next) {
    Stage stage;
    stage.time_s = p.time_s + p.h;
    stage.inertia_1_s2 = 1.0 / (p.h * p.h);
    stage.constant = (stage.inertia_1_s2 * s.x + (1.0 / p.h + p.velocity_force_1_s) * s.v) * p.mass;
    stage.rate_factor_1_s = 1.0 / p.h;
    stage.rate_history = -s.strain / p.h;
    StageSolution end;
    if (!p.solve(stage, end)) return false;
    next.v = (end.x - s.x) / p.h;
    next.force = ((next.v - s.v) / p.h) * p.mass;
    next.rate = (end.strain - s.strain) / p.h;
    next.x = std::move(end.x);
    next.strain = std::move(end.strain);
    return true;
}

/// TR-BDF2 with gamma = 2 - sqrt(2): second order, L-stable, both stages with the same matrix.
/// Source: Bank et al. 1985; Hosea & Shampine 1996.
template <class Solve>
bool tr_bdf2_step(const StepProblem<Solve>& p, const Kinematics& s, Kinematics& next) {
    const double gamma = 2.0 - std::sqrt(2.0);
    const double d = 0.5 * gamma * p.h;                                          // both stages: v = x / d + ...
    const double c1 = 1.0 / (gamma * (2.0 - gamma)), c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
    const double lambda = p.velocity_force_1_s;

    Stage trapezoid;
    trapezoid.time_s = p.time_s + gamma * p.h;
    trapezoid.inertia_1_s2 = 1.0 / (d * d) - lambda / d;
    trapezoid.constant = (s.x / (d * d) + 2.0 / d * s.v - lambda * (s.x / d + s.v)) * p.mass + s.force;
    trapezoid.rate_factor_1_s = 1.0 / d;
    trapezoid.rate_history = -s.strain / d - s.rate;
    StageSolution middle;
    if (!p.solve(trapezoid, middle)) return false;
    const Eigen::Matrix3Xd v1 = (middle.x - s.x) / d - s.v;

    Stage bdf2;
    const Eigen::Matrix3Xd history = (c1 * middle.x - c0 * s.x) / d;             // v2 = x2 / d - history
    bdf2.time_s = p.time_s + p.h;
    bdf2.inertia_1_s2 = 1.0 / (d * d) - lambda / d;
    bdf2.constant = (history / d + (c1 * v1 - c0 * s.v) / d - lambda * history) * p.mass;
    bdf2.rate_factor_1_s = 1.0 / d;
    bdf2.rate_history = (c0 * s.strain - c1 * middle.strain) / d;
    StageSolution end;
    if (!p.solve(bdf2, end)) return false;
    next.v = end.x / d - history;
    next.force = ((next.v - c1 * v1 + c0 * s.v) / d) * p.mass;
    next.rate = end.strain / d + bdf2.rate_history;
    next.x = std::move(end.x);
    next.strain = std::move(end.strain);
    return true;
}

template <class Solve>
bool take_step(Integrator integrator, const StepProblem<Solve>& problem, const Kinematics& start, Kinematics& next) {
    if (integrator == Integrator::implicit_euler) return implicit_euler_step(problem, start, next);
    return tr_bdf2_step(problem, start, next);
}

}  // namespace myo
