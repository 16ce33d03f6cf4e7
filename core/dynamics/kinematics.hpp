#pragma once

#include <Eigen/Core>

#include "dynamics/stage_solver.hpp"

namespace myo::dynamics {

/// State that an integrator carries from step to step.
///
/// The same struct holds the derivative of the state with respect to a parameter: apart from the stage solves every
/// integrator is linear in it, so one implementation serves both the run and its tangent.
struct Kinematics {
    Eigen::Matrix3Xd x;      // positions, 3 x n [m]
    Eigen::Matrix3Xd v;      // velocities, 3 x n [m/s]
    Eigen::Matrix3Xd force;  // M times acceleration [N], zero on clamped nodes
    Eigen::VectorXd strain;  // strain measures at x; creeping body: followed by those of the dashpots (see creep.hpp)
    Eigen::VectorXd rate;    // rates of the strain measures [1/s]

    // Memory of multi-step schemes: their slopes of positions, momenta and strains, minus the derivatives v, force and
    // rate. Stored as differences they remain valid where `force` is recomputed at a jump: a difference is of the size
    // of one step, and the error it has for the momenta of a changed mass does not reduce the order.
    // Empty at the start of a run: zero.
    double step_before_s = 0.0;  // length of the step that set this memory [s]; 0: none
    Eigen::Matrix3Xd v_lag;      // [m/s]
    Eigen::Matrix3Xd force_lag;  // [N]
    Eigen::VectorXd rate_lag;    // [1/s]
};

/// Solution of a stage: positions and strain measures, or their derivatives.
struct StageSolution {
    Eigen::Matrix3Xd x;      // 3 x n [m]
    Eigen::VectorXd strain;  // layout of Kinematics::strain
};

/// Data of one step besides the state.
///
/// `solve` is called once per stage, in order. If it returns false, the step is abandoned and returns false as well.
template <class Solve>
struct StepProblem {
    const model::MassMatrix& mass;    // for the whole step: masses appear and disappear only at its ends
    double time_s = 0.0;              // start of the step
    double h = 0.0;                   // length of the step [s]
    double velocity_force_1_s = 0.0;  // Lambda: velocity force per momentum
    Solve solve;                      // bool(Stage&, StageSolution&); may evaluate the loads left of a jump

    /// Midpoint of the step [s]. The mass is looked up there, away from jumps at the ends.
    double middle_s() const { return time_s + 0.5 * h; }
};

}  // namespace myo::dynamics
