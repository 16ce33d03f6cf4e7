#pragma once

#include <filesystem>
#include <vector>

namespace myo::app {

/// Published measurements and results in data_folder() that `bench` and `reproduce` read; empty if it is missing.
/// Commands refuse to overwrite them.
std::vector<std::filesystem::path> reference_files();

}  // namespace myo::app
