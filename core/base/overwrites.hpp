#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo {

/// Makes sure that no output is a file that is read as well: the same file, however it is spelled or linked.
///
/// @param named_by  the option or folder that named the outputs, as "--out"
/// Error: "--out: exp/drop.csv is read as input and would be replaced; choose another file or folder"
Result<void> check_overwrites(const std::string& named_by, const std::vector<std::filesystem::path>& outputs,
                              const std::vector<std::filesystem::path>& inputs);

}  // namespace myo
