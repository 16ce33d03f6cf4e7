#pragma once

#include "commands/run_result.hpp"
#include "prediction/run_trials.hpp"

namespace myo::backend {

/// A run as the workbench shows it. Frames are thinned so that a long run of a large body stays within some 200 MB a
/// trial.
ui::commands::RunResult shown_run(const setup::Setup& setup, const prediction::SetupRun& run);

/// The vibrations that the trials of a run show, of steps_seen_in() it.
void add_vibrations(const std::vector<setup::TrialStep>& seen, ui::commands::RunResult& shown);

}  // namespace myo::backend
