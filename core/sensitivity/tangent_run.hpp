#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/simulate.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::sensitivity {

// Forward sensitivities follow the run step by step, at a cost proportional to the number of parameters. They supply
// the Jacobian of residuals for Gauss-Newton methods; the adjoint (adjoint_run.hpp) supplies the gradient of one loss.

/// Derivatives of the motion of k chosen nodes with respect to one parameter, the start first, then after every step.
struct NodeTangent {
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x k [m per unit]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x k [m/s per unit]
};

/// A run with its tangents.
struct SensitiveTrace {
    dynamics::Trace trace;
    std::vector<NodeTangent> tangents;  // per parameter; one entry per state of the trace
};

/// Simulates a model together with the exact derivatives of the discrete motion (forward sensitivities).
///
/// Each stage costs one Hessian and one linear solve per parameter. Apart from the stage solves a step is linear in the
/// state, so the formulas of the run also serve its derivative. Parameters share the loops over cells, the mass and the
/// factor, so that many parameters cost a fraction of as many runs.
///
/// @param nodes  nodes whose derivatives are stored
/// Errors: those of simulate(), in trace.status.
SensitiveTrace simulate_with_tangents(const model::Model& model, const dynamics::SimulationOptions& options,
                                      const std::vector<ModelTangent>& parameters, const std::vector<int>& nodes,
                                      const Progress& progress = {});

}  // namespace myo::sensitivity
