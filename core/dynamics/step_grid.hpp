#pragma once

#include <vector>

#include "model/model.hpp"

namespace myo::dynamics {

/// Ends of the steps of a run [s], ascending: multiples of h up to `end_s` and the jumps of the model.
std::vector<double> step_ends(const model::Model& model, double h_s, double end_s);

/// Whether t is one of the jumps, within 1e-6 h.
bool is_jump(const std::vector<double>& jumps, double t, double h_s);

}  // namespace myo::dynamics
