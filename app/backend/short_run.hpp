#pragma once

#include "prediction/run_trials.hpp"

namespace myo::backend {

/// One trial up to `end_s`, identical step by step to a full run with the same step. Used while a value is dragged.
///
/// @param values  of all parameters, also those that do not affect this trial
/// @param trial   index in the setup
/// @param end_s   end of the simulated time [s]
/// @return        later samples are NaN, other trials have status not_run; a run that failed or was cancelled keeps the
///                steps before, without samples
prediction::SetupRun short_run(const setup::Setup& setup, const prediction::ParameterValues& values, std::size_t trial,
                               double end_s, const Progress& progress = {});

}  // namespace myo::backend
