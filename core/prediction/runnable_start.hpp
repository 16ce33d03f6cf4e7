#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Start of a fit whose declared start has no equilibrium, or comes to no end: a body that gives way under its
/// commands is stiffer than declared. The fitted moduli are raised together, within their bounds, until all trials can
/// be run.
///
/// @param values      start at which a trial failed
/// @param parameters  of the fit
/// @return            empty if no modulus is fitted, if none within the bounds will do, or if cancelled
std::optional<ParameterValues> runnable_start(const setup::Setup& setup, const ParameterValues& values,
                                              const std::vector<ModelParameter>& parameters,
                                              const std::vector<std::size_t>& trials, const Progress& progress);

}  // namespace myo::prediction
