#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "calibration/body_design.hpp"
#include "calibration/optimize.hpp"

namespace myo::results {

/// Text of experiment.toml with what a search found: fibre directions, masks, moduli, and the signals of its trial, in
/// place of what was declared for them.
///
/// @param written  the experiment.toml that was opened
/// @param folder   where the text will stand, together with the files of write_masks() and of the found signals
/// @param trial    index of the trial in the file
/// @param skipped  receives a sentence on signals that cannot be stated in the file; may be null
/// Errors: the file cannot be read, or a value cannot be set in it.
Result<std::string> optimized_experiment(const std::filesystem::path& written, const std::filesystem::path& folder,
                                         const setup::Setup& setup, const calibration::Optimization& optimization,
                                         std::size_t trial, std::string* skipped = nullptr);

/// Names of the files of write_masks().
/// Known before the search ends, so that a job can refuse to overwrite its input.
///
/// @param seek  what is sought; moduli need no mask
std::vector<std::filesystem::path> mask_files(const experiment::Experiment& experiment,
                                              const std::vector<calibration::SoughtItem>& seek);

/// Writes `<muscle>_mask.csv` for each muscle whose paint was changed.
/// Errors: a file cannot be written.
Result<void> write_masks(const std::filesystem::path& folder, const experiment::Experiment& experiment,
                         const std::vector<calibration::FoundItem>& found);

}  // namespace myo::results
