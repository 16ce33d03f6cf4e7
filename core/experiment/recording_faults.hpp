#pragma once

#include <string>
#include <vector>

#include "experiment/read_trial.hpp"

namespace myo::experiment {

/// Corrects the faults of a recording, each with a warning.
///
/// Samples at exactly 0, 0, 0 that no motion explains, positions that repeat exactly while the body moves, reflections
/// and stretches in which the cameras followed something else become gaps; names that were exchanged are restored.
/// Sets `rounding_m`.
///
/// @param key   of the trace, for the warnings: "trial[1].trace"
/// @param read  in/out: tracks under their declared names
void correct_faults(const Experiment& experiment, const std::string& key, TrialRecording& read);

/// Words in quotes, separated by commas.
std::string quoted_list(const std::vector<std::string>& words);

}  // namespace myo::experiment
