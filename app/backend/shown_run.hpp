#pragma once

#include "commands/run_result.hpp"
#include "project/run_study.hpp"

namespace myo {

/// A run as the workbench shows it. Frames are thinned so that a long run of a large body stays within some 200 MB a trial.
RunResult shown_run(const Study& study, const StudyRun& run);

/// The vibrations that the trials of a run show, of steps_seen_in() it.
void add_vibrations(const std::vector<TrialStep>& seen, RunResult& shown);

}  // namespace myo
