#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// The experiment.toml of a case.
std::string experiment_text(const SyntheticCase& c);

/// Experiment, surface, actuations, and traces of a body that does not move. Error: a file cannot be written.
Result<void> write_still_experiment(const SyntheticCase& c, const std::filesystem::path& folder);

/// What the cameras report of these motions: turned into their frame, with noise, and with one marker hidden for a
/// while.
///
/// @param positions_m  per trial and marker 3 x samples, mesh frame
/// Error: a file cannot be written.
Result<void> write_traces(const SyntheticCase& c, const std::vector<std::vector<Eigen::Matrix3Xd>>& positions_m,
                          const std::filesystem::path& folder);

}  // namespace myo::validation
