#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "prediction/run_trials.hpp"

namespace myo::results {

/// File names without extension, one per trial: the trial's name with unsafe characters replaced by '_', and a number
/// appended if two would be equal.
std::vector<std::string> trial_file_names(const std::vector<std::string>& trial_names);
/// File names of the trials of an experiment, in their order.
std::vector<std::string> trial_file_names(const experiment::Experiment& experiment);

/// Writes `<trial>.csv` for each completed trial: simulated markers at the measured sample times, mesh frame [m].
///
/// Errors: a file cannot be written.
Result<void> write_traces(const std::filesystem::path& folder, const setup::Setup& setup,
                          const prediction::SetupRun& run);

/// Writes `<trial>.pvd` and `<trial>_frames/<number>.vtu` for each completed trial: the deformed mesh with displacement
/// [m] and velocity [m/s] at the nodes.
///
/// @param frames  number of states, equally spaced in time; fewer if the run has fewer steps
/// Errors: a file cannot be written; cancelled. After an error the series of that trial is removed.
Result<void> write_series(const std::filesystem::path& folder, const setup::Setup& setup,
                          const prediction::SetupRun& run, int frames, const Progress& progress = {});

/// All input files of an experiment: declaration, surface or volume mesh, parts, laws, traces, actuations, sensors,
/// goals, signals and masks. A job compares them with its outputs.
///
/// @param declared  the experiment folder or its .toml file, as read_experiment() takes it
std::vector<std::filesystem::path> files_read(const std::filesystem::path& declared,
                                              const experiment::Experiment& experiment);

/// Files that write_traces() may write for this experiment.
/// Known before the run, for the comparison with files_read(). Trials that fail write none.
std::vector<std::filesystem::path> trace_files(const std::filesystem::path& folder,
                                               const experiment::Experiment& experiment);

/// Files that write_series() may write or remove for this experiment.
std::vector<std::filesystem::path> series_files(const std::filesystem::path& folder,
                                                const experiment::Experiment& experiment, int frames);

/// Creates an output folder and tests whether files can be written to it, before a long job starts.
///
/// Errors: the path is a file, the folder cannot be created or is not writable.
Result<void> prepare_output_folder(const std::filesystem::path& folder);

}  // namespace myo::results
