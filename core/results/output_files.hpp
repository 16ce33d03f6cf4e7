#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "prediction/run_trials.hpp"

namespace myo::results {

/// File names without extension, one per trial: the trial's name, with characters that are awkward in a file name
/// replaced by '_', and a number where two would be the same.
std::vector<std::string> trial_file_names(const std::vector<std::string>& trial_names);
std::vector<std::string> trial_file_names(const experiment::Experiment& experiment);

/// Writes `<trial>.csv` for each trial that completed: its simulated markers at the measured sample times, mesh frame
/// [m]. Error: a file cannot be written.
Result<void> write_traces(const std::filesystem::path& folder, const setup::Setup& setup,
                          const prediction::SetupRun& run);

/// Writes `<trial>.pvd` and `<trial>_frames/<number>.vtu` for each trial that completed: about `frames` states at equal
/// distances in time, the mesh as deformed, with displacement [m] and velocity [m/s] at the nodes. A cancelled series
/// leaves nothing behind. Errors: a file cannot be written; cancelled.
Result<void> write_series(const std::filesystem::path& folder, const setup::Setup& setup,
                          const prediction::SetupRun& run, int frames, const Progress& progress = {});

/// All files that an experiment is read from: its declaration, its surface, traces, actuations, signals and masks.
///
/// @param declared  the experiment folder, or its .toml file, as read_experiment() takes it
std::vector<std::filesystem::path> files_read(const std::filesystem::path& declared,
                                              const experiment::Experiment& experiment);

/// The files that write_traces() may write for this experiment.
std::vector<std::filesystem::path> trace_files(const std::filesystem::path& folder,
                                               const experiment::Experiment& experiment);

/// The files that write_series() may write or remove for this experiment.
std::vector<std::filesystem::path> series_files(const std::filesystem::path& folder,
                                                const experiment::Experiment& experiment, int frames);

/// Makes the folder where results will go and tests whether files can be written there.
/// Errors: it is a file, cannot be made or is not writable.
Result<void> prepare_output_folder(const std::filesystem::path& folder);

}  // namespace myo::results
