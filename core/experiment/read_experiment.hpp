#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"

namespace myo::experiment {

/// Reads `<folder>/experiment.toml` (schema experiment/1); a path to a TOML file itself is taken as that file.
///
/// @param overrides  keys and values from the command line (`--set key=value`), see override_toml(); an error in one of
///                   them has "--set" as its place
/// Errors: everything that can be seen without the traces and an STL's triangles; for those see read_trial.hpp and
/// check_body.hpp. `where` is file and line, `what` begins
/// with the key: "trial[1].load[0].box_m: lowest corner is above the highest (z 0.03 > 0.01)".
Result<Experiment> read_experiment(const std::filesystem::path& folder,
                                   const std::vector<std::pair<std::string, std::string>>& overrides = {});

/// Where a key stands, for checks that come later: "folder/experiment.toml:41", or "--set". For an absent key the place
/// of the nearest table around it, at last the file.
std::string location_of(const Experiment& experiment, const std::string& key);

/// "key: sentence" at the key's place.
Error declaration_error(const Experiment& experiment, const std::string& key, const std::string& sentence);

}  // namespace myo::experiment
