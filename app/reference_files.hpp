#pragma once

#include <filesystem>
#include <vector>

namespace myo::app {

/// The published measurements and results in data_folder(), which `bench` and `reproduce` read; none where it is
/// missing.
std::vector<std::filesystem::path> reference_files();

}  // namespace myo::app
