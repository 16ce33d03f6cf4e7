#pragma once

#include <cstddef>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::ui::commands {

/// What a time step of a run took.
struct StepCost {
    mesh::CellType element = mesh::CellType::hex8;
    double dofs = 0.0;
    double seconds = 0.0;  // wall time of the run over the steps of all its trials

    bool operator==(const StepCost&) const = default;
};

inline constexpr std::size_t most_step_costs = 24;

/// Appends it, in place of an earlier one of the same mesh. The oldest go where there are too many.
void remember(std::vector<StepCost>& costs, const StepCost& cost);

/// What a step would take, from the newest run with these elements (else the newest of all, else the documented
/// benchmark).
struct StepPrediction {
    double seconds = 0.0;
    StepCost from;
    double exponent = 0.0;  // p of seconds ~ DOF^p
    bool fitted = false;    // p comes from these runs, not from the benchmark
    bool measured = false;  // on this machine; else `from` is the benchmark's
};

/// p is fitted where runs with these elements differ in size by a factor of 1.5 at least; else it is that of `myoloop
/// bench scaling`, and 1 below its sizes.
StepPrediction predict_step(const std::vector<StepCost>& costs, mesh::CellType element, double dofs);

}  // namespace myo::ui::commands
