#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"

namespace myo::experiment {

/// Reads and checks `<folder>/experiment.toml` (schema experiment/1).
///
/// @param folder     directory of the experiment, or the path of a TOML file
/// @param overrides  keys and values from the command line (`--set key=value`), see override_toml(); errors in them are
///                   located at "--set"
/// Errors: every error that can be detected without the traces and the triangles of a surface file; for those see
/// read_trial.hpp and check_body.hpp. `where` is file and line, `what` begins with the key: "trial[1].load[0].box_m:
/// lowest corner is above the highest (z 0.03 > 0.01)".
Result<Experiment> read_experiment(const std::filesystem::path& folder,
                                   const std::vector<std::pair<std::string, std::string>>& overrides = {});

/// Reads and checks the text of an experiment.toml that need not be the one on disk, such as one with edits.
///
/// @param file  path of the text for messages; files that it names are resolved against its folder
/// Errors: those of read_experiment().
Result<Experiment> read_experiment_text(const std::string& text, const std::filesystem::path& file);

/// Source location of a key, for checks after reading: "folder/experiment.toml:41", or "--set".
///
/// @return   location of the key; if it is absent, of the nearest enclosing table, finally of the file
std::string location_of(const Experiment& experiment, const std::string& key);

/// Error "key: sentence" at the location of the key.
Error declaration_error(const Experiment& experiment, const std::string& key, const std::string& sentence);

}  // namespace myo::experiment
