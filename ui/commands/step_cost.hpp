#pragma once

#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo {

/// What a time step of a run took.
struct StepCost {
    CellType element = CellType::hex8;
    double dofs = 0.0;
    double seconds = 0.0;   // wall time of the run over the steps of all its trials
};

/// Appends it, in place of an earlier one of the same mesh.
void remember(std::vector<StepCost>& costs, const StepCost& cost);

/// What a step would take, from the newest run with these elements (else the newest of all).
struct StepPrediction {
    double seconds = 0.0;
    StepCost from;
    double exponent = 0.0;   // p of seconds ~ DOF^p
    bool fitted = false;     // p comes from these runs, not from the benchmark
};

/// p is fitted where runs with these elements differ in size by a factor of 1.5 at least; else it is that of `myoloop bench scaling`.
/// @param costs  not empty
StepPrediction predict_step(const std::vector<StepCost>& costs, CellType element, double dofs);

}  // namespace myo
