#pragma once

#include "prediction/run_trials.hpp"

namespace myo::backend {

/// One trial up to `end_s`, identical step by step to a full run. Later samples are NaN, other trials have status
/// not_run.
prediction::SetupRun short_run(const setup::Setup& setup, const prediction::ParameterValues& values, std::size_t trial,
                               double end_s, const Progress& progress = {});

}  // namespace myo::backend
