#pragma once

#include <Eigen/Core>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// What an integrator carries from step to step. The same struct holds the derivative of all of it with respect to a
/// parameter: every integrator is linear in it but for the stage solves.
struct Kinematics {
    Eigen::Matrix3Xd x;      // positions, 3 x n [m]
    Eigen::Matrix3Xd v;      // velocities [m/s]
    Eigen::Matrix3Xd force;  // M times acceleration [N], zero on clamped nodes
    Eigen::VectorXd
        strain;            // strain measures at x; where the body creeps, those of its dashpots follow (see creep.hpp)
    Eigen::VectorXd rate;  // their rates [1/s]

    // Memory of schemes that look back: the slopes they keep of positions, momenta and strains, less the derivatives v,
    // force and rate. As differences they stay valid where `force` is set anew at a jump: they are of the size of a
    // step, and what the momenta of another mass have there costs no order. Empty at the start of a run: zero.
    double step_before_s = 0.0;  // length of the step that left this memory; 0: none
    Eigen::Matrix3Xd v_lag;      // [m/s]
    Eigen::Matrix3Xd force_lag;  // [N]
    Eigen::VectorXd rate_lag;    // [1/s]
};

/// Solution of a stage: positions and strain measures there, or their derivatives.
struct StageSolution {
    Eigen::Matrix3Xd x;
    Eigen::VectorXd strain;
};

/// Everything a step needs from its surroundings besides the state. `solve` is called once per stage, in order.
/// It returns false to give up; then the step returns false too.
template <class Solve>
struct StepProblem {
    const model::MassMatrix& mass;  // of the whole step: masses leave and join at its ends
    double time_s = 0.0;            // start of the step
    double h = 0.0;
    double velocity_force_1_s = 0.0;  // Lambda
    Solve solve;                      // bool(Stage&, StageSolution&); it may move the stage to the loads left of a jump

    double middle_s() const { return time_s + 0.5 * h; }
};

}  // namespace myo::dynamics
