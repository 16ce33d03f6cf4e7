#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// Content of the experiment.toml of a case: what a laboratory would declare. The true values, the effect and its size
/// are not in it.
std::string experiment_text(const SyntheticCase& c);

/// Writes declaration, surface, actuations, and traces of a body that does not move. The folder can then be read, which
/// the simulation of the truth needs.
///
/// Errors: a file cannot be written.
Result<void> write_still_experiment(const SyntheticCase& c, const std::filesystem::path& folder);

/// Writes the traces of these motions as recorded by the cameras: in their frame, with noise, one marker occluded for a
/// while.
///
/// @param positions_m  per trial and marker 3 x samples, mesh frame
/// Errors: a file cannot be written.
Result<void> write_traces(const SyntheticCase& c, const std::vector<std::vector<Eigen::Matrix3Xd>>& positions_m,
                          const std::filesystem::path& folder);

}  // namespace myo::validation
