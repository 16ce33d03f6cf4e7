#pragma once

#include "commands/run_result.hpp"
#include "prediction/run_trials.hpp"

namespace myo::backend {

/// A run as the workbench displays it, with frames thinned to about 200 MB per trial.
ui::commands::RunResult shown_run(const setup::Setup& setup, const prediction::SetupRun& run);

/// Adds the dominant frequency of each trial from steps_seen_in().
void add_vibrations(const std::vector<setup::TrialStep>& seen, ui::commands::RunResult& shown);

}  // namespace myo::backend
