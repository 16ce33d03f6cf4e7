#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

#include "dynamics/simulate.hpp"
#include "sensitivity/model_gradient.hpp"

namespace myo::sensitivity {

/// Motion of k chosen nodes, the start first.
struct NodeMotion {
    std::vector<double> times_s;               // one per state, ascending
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x k [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x k [m/s]
};

/// Loss of a motion and its derivatives, one matrix per time of the motion. Empty vectors or matrices: zero.
struct MotionLoss {
    double value = 0.0;                          // dimensionless
    std::vector<Eigen::Matrix3Xd> d_positions;   // 3 x k [1/m]
    std::vector<Eigen::Matrix3Xd> d_velocities;  // 3 x k [s/m]
};

/// A loss as a function of the motion of some nodes.
struct LossOfMotion {
    std::vector<int> nodes;  // observed nodes, in the order of the columns of NodeMotion
    std::function<MotionLoss(const NodeMotion&)>
        evaluate;  // called once, after the forward run and before the backward pass
};

/// Accuracy and memory of the adjoint.
struct AdjointOptions {
    /// Relative residual of the linear solves. Measured on 160 steps of the beam (4,608 DOF) against 1e-12: the error
    /// of gradients with respect to moduli and signals is at most 5e-8 with this value, 6e-7 with 1e-5.
    double tolerance = 1e-6;
    /// Memory budget for the stored run [bytes], not counting solver, gradient and motion of the observed nodes. A run
    /// that exceeds it is split into parts: only the states at the splits are stored, and each part but the last is run
    /// twice (checkpointing). The estimate assumes unhalved steps; halved steps need more.
    double memory_bytes = 256e6;
    /// Also compute the derivative with respect to damping for an undamped body; one pass over the strains per stage.
    bool damping_of_undamped = false;
    bool fibre_points = false;  // also the derivatives with respect to shape, hence direction, and volume of each fibre
};

/// Result of simulate_with_gradient().
struct GradientRun {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;  // failed and cancelled runs have no gradient
    std::string message;
    NodeMotion motion;  // of the nodes of the loss
    double loss = 0.0;
    ModelGradient gradient;   // valid if complete()
    int steps = 0;            // taken by the run, halved ones included
    int parts = 1;            // number of parts the run was split into
    double tape_bytes = 0.0;  // largest memory of the tape, estimated

    /// Whether the gradient is valid.
    bool complete() const { return status == dynamics::RunStatus::complete; }
};

/// Exact gradient of the discrete run with respect to all model parameters, by the adjoint of every step, backwards.
///
/// Costs one exact Hessian and one linear solve per stage, independent of the number of parameters. The steps of all
/// integrators are transposed through their StepCoefficients. Splitting the run into parts changes the gradient only
/// within the solver tolerance, because each part starts with a new solver; whether a part is stored or repeated makes
/// no difference at all.
///
/// The memory of creeping and softening bodies is transposed as well. Parameters of the Maxwell branch and of the
/// softening themselves have no gradient here: tangents supply it.
///
/// @param loss     evaluated once, on the complete motion
/// @param adjoint  accuracy and memory
/// Errors (status and message): those of simulate(); a start with inverted cells; a singular equilibrium; a memory
/// budget below the minimum.
GradientRun simulate_with_gradient(const model::Model& model, const dynamics::SimulationOptions& options,
                                   const LossOfMotion& loss, const AdjointOptions& adjoint = {},
                                   const Progress& progress = {});

}  // namespace myo::sensitivity
