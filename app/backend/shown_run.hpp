#pragma once

#include "commands/run_result.hpp"
#include "prediction/run_trials.hpp"

namespace myo::backend {

/// A run as the workbench displays it, with frames thinned to about 200 MB per trial. Trials that did not run have no
/// frames, those that failed no markers.
///
/// Markers are shifted and rotated by the registration of the run, so that they can be compared with the measurement.
ui::commands::RunResult shown_run(const setup::Setup& setup, const prediction::SetupRun& run);

/// Adds the dominant frequency of each trial [Hz]; 0 where none is visible.
///
/// @param seen  result of steps_seen_in() for the same run, one entry per trial
void add_vibrations(const std::vector<setup::TrialStep>& seen, ui::commands::RunResult& shown);

}  // namespace myo::backend
