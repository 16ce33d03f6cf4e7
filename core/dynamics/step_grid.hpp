#pragma once

#include <vector>

#include "model/model.hpp"

namespace myo::dynamics {

/// Ends of the steps of a run, ascending: jumps of the model and multiples of h up to `end`.
std::vector<double> step_ends(const model::Model& model, double h_s, double end_s);

/// Whether one of these times is t, to within rounding beside h.
bool is_jump(const std::vector<double>& jumps, double t, double h_s);

}  // namespace myo::dynamics
