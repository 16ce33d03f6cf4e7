#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "project/run_study.hpp"

namespace myo {

/// File names without extension, one per trial: the trial's name, with characters that are awkward in a file name replaced
/// by '_', and a number where two would be the same.
std::vector<std::string> trial_file_names(const std::vector<std::string>& trial_names);
std::vector<std::string> trial_file_names(const Experiment& experiment);

/// Writes `<trial>.csv` for each trial that completed: its simulated markers at the measured sample times, mesh frame [m].
/// Error: a file cannot be written.
Result<void> write_traces(const std::filesystem::path& folder, const Study& study, const StudyRun& run);

/// Writes `<trial>.pvd` and `<trial>_frames/<number>.vtu` for each trial that completed: about `frames` states at equal
/// distances in time, the mesh as deformed, with displacement [m] and velocity [m/s] at the nodes. A cancelled series leaves
/// nothing behind.
/// Errors: a file cannot be written; cancelled.
Result<void> write_series(const std::filesystem::path& folder, const Study& study, const StudyRun& run, int frames,
                          const Progress& progress = {});

/// The tables that an experiment reads beside its experiment.toml: traces, actuations, masks.
std::vector<std::filesystem::path> tables_read(const Experiment& experiment);

/// Makes the folder where results will go and sees whether files can be written there.
/// Errors: it is a file, cannot be made, is not writable, or results would replace a file that the experiment reads.
Result<void> prepare_output_folder(const std::filesystem::path& folder, const Experiment& experiment);

}  // namespace myo
