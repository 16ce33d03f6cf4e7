#pragma once

#include "prediction/run_trials.hpp"

namespace myo::backend {

/// One trial, as far as `end_s`: step for step as in a whole run. Samples after that are NaN, the other trials have
/// status not_run.
prediction::SetupRun short_run(const setup::Setup& setup, const prediction::ParameterValues& values, std::size_t trial,
                               double end_s, const Progress& progress = {});

}  // namespace myo::backend
