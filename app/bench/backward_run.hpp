#pragma once

#include <string>
#include <vector>

#include "base/box.hpp"
#include "bench/bench_case.hpp"
#include "dynamics/simulate.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// Time of the backward pass for the gradient with respect to all moduli, signals and parameters of force elements,
/// compared with the forward run. The loss is a function of the nodes of the tip.
///
/// @param name        of the row
/// @param tip         box [m] around these nodes
/// @param references  times of other programs for a backward pass, per step
/// @return            times of the backward pass per step; its goal is 0.8 of the forward run
/// Errors: a run did not complete.
Result<BenchFigures> measure_backward(const std::string& name, const model::Model& model, const Box& tip,
                                      const dynamics::SimulationOptions& options,
                                      const std::vector<BenchReference>& references);

}  // namespace myo::bench
