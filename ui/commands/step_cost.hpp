#pragma once

#include <cstddef>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::ui::commands {

/// Measured cost of one time step.
struct StepCost {
    mesh::CellType element = mesh::CellType::hex8;
    double dofs = 0.0;     // degrees of freedom
    double seconds = 0.0;  // wall time of the run divided by the steps of all its trials

    bool operator==(const StepCost&) const = default;
};

// Number of measurements kept in the preferences.
inline constexpr std::size_t max_step_costs = 24;

/// Appends a measurement. It replaces an earlier one of the same element type and size; the oldest is dropped if there
/// are too many. Ignores values that are not positive.
void remember(std::vector<StepCost>& costs, const StepCost& cost);

/// Predicted cost of one time step, extrapolated from the newest run with these elements; without one from the newest
/// run, otherwise from the documented benchmark.
struct StepPrediction {
    double seconds = 0.0;   // wall time per step
    StepCost from;          // measurement it is extrapolated from
    double exponent = 0.0;  // p in seconds ~ DOF^p
    bool fitted = false;    // p was fitted to runs on this machine; otherwise it is that of the benchmark
    bool measured = false;  // `from` was measured on this machine; otherwise it is the benchmark
};

/// Predicts the cost for a mesh of this size. p is fitted if runs with these elements differ in size by a factor of at
/// least 1.5. Otherwise it is that of `myoloop bench scaling`, and 1 below the sizes measured there.
StepPrediction predict_step(const std::vector<StepCost>& costs, mesh::CellType element, double dofs);

}  // namespace myo::ui::commands
