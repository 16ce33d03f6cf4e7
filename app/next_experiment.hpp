#pragma once

#include <filesystem>
#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "diagnosis/diagnosis.hpp"
#include "planning/propose_trial.hpp"

namespace myo::app {

/// The trial that would separate what a diagnosis could not, found with a small share of the runs that it took. Empty
/// where everything was separated, where no trial can be run, or if cancelled.
///
/// @param setup        as given to the diagnosis
/// @param declaration  file of the experiment
/// Errors: the declaration cannot be read, as it is or with a further trial.
Result<std::optional<planning::Proposal>> next_experiment(const setup::Setup& setup,
                                                          const diagnosis::Diagnosis& diagnosis,
                                                          const std::filesystem::path& declaration,
                                                          const Progress& progress);

/// Writes the signal of the best trial into a folder, if it has one; its name is planning::signal_file. Errors: the
/// file cannot be written.
Result<void> write_signal(const std::filesystem::path& folder, const planning::Proposal& proposal);

}  // namespace myo::app
