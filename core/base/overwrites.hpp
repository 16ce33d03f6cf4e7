#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo {

/// Fails if an output would overwrite an input. Files are compared by identity, not by spelling: links count too.
///
/// @param named_by  option or folder that named the outputs, for example "--out"
/// Error: "--out: exp/drop.csv is read as input and would be replaced; choose another file or folder"
Result<void> check_overwrites(const std::string& named_by, const std::vector<std::filesystem::path>& outputs,
                              const std::vector<std::filesystem::path>& inputs);

}  // namespace myo
