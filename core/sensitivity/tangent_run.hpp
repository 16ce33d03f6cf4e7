#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/simulate.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::sensitivity {

/// Derivatives of chosen nodes' motion with respect to one parameter, after every step (the start first).
struct NodeTangent {
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x k [m per unit]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x k [m/s per unit]
};

struct SensitiveTrace {
    dynamics::Trace trace;
    std::vector<NodeTangent> tangents;  // per parameter; as long as the trace
};

/// simulate() with the exact derivative of the discrete motion with respect to each parameter, in lockstep.
///
/// nodes: those whose derivatives are kept. Each stage costs one Hessian and one linear solve per parameter; the stage
/// recursions are those of the run itself, which are linear but for the stage solves. Parameters share the passes over
/// cells, mass and factor, so that many together cost a fraction of as many runs.
SensitiveTrace simulate_with_tangents(const model::Model& model, const dynamics::SimulationOptions& options,
                                      const std::vector<ModelTangent>& parameters, const std::vector<int>& nodes,
                                      const Progress& progress = {});

}  // namespace myo::sensitivity
