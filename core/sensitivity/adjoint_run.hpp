#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

#include "dynamics/simulate.hpp"
#include "sensitivity/model_gradient.hpp"

namespace myo::sensitivity {

/// Motion of chosen nodes, the start first.
struct NodeMotion {
    std::vector<double> times_s;
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x k [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x k [m/s]
};

/// A loss of such a motion and its derivatives, per time as in the motion. Empty: zero.
struct MotionLoss {
    double value = 0.0;
    std::vector<Eigen::Matrix3Xd> d_positions;   // 3 x k [1/m]
    std::vector<Eigen::Matrix3Xd> d_velocities;  // 3 x k [s/m]
};

struct LossOfMotion {
    std::vector<int> nodes;
    std::function<MotionLoss(const NodeMotion&)> evaluate;  // called once, between the run and its transposition
};

struct AdjointOptions {
    /// Relative residual of the linear solves. Measured on 160 steps of the beam (4,608 DOF) against 1e-12: gradients
    /// with respect to moduli and signals are off by at most 5e-8 here, 6e-7 at 1e-5.
    double tolerance = 1e-6;
    /// For what is kept of the run [bytes]; not counted are solver, gradient and motion of the chosen nodes. A run that
    /// does not fit is cut: states are kept where it is cut, and its parts run twice. Counted with whole steps; those
    /// that a run halves come on top.
    double memory_bytes = 256e6;
    /// The derivative with respect to damping of a body that has none; costs a pass over the strains per stage.
    bool damping_of_undamped = false;
    bool fibre_shapes = false;  // and so directions
};

/// A run with the gradient of its loss.
struct GradientRun {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    NodeMotion motion;
    double loss = 0.0;
    ModelGradient gradient;  // when complete
    int steps = 0;
    int parts = 1;            // into which the run was cut
    double tape_bytes = 0.0;  // kept of the run at once, at most

    bool complete() const { return status == dynamics::RunStatus::complete; }
};

/// The exact derivative of the discrete run with respect to everything in the model, the adjoint of every step taken
/// backwards.
///
/// Costs one exact Hessian and one linear solve per stage, however many parameters there are. Every integrator's step
/// is transposed by its own coefficients (StepCoefficients). The gradient does not depend on the parts a run is cut
/// into, but for the tolerance of the solver, which starts anew in each; whether a part is kept or run again makes no
/// difference at all. Errors: those of simulate(); a body that creeps or softens; a start with cells turned inside out
/// has no gradient; a budget that does not hold the least.
GradientRun simulate_with_gradient(const model::Model& model, const dynamics::SimulationOptions& options,
                                   const LossOfMotion& loss, const AdjointOptions& adjoint = {},
                                   const Progress& progress = {});

}  // namespace myo::sensitivity
