#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace myo::test {

/// Path of a file or folder of the measured data, in the folder MYOLOOP_DATA or next to the checkout. Empty if it does
/// not exist.
inline std::filesystem::path shared_data(const std::string& part) {
    // The environment variable takes precedence, so that a build in another place finds the data.
    const char* const named = std::getenv("MYOLOOP_DATA");
    const std::filesystem::path folder = named != nullptr ? std::filesystem::path(named)
                                                          : std::filesystem::path(MYOLOOP_SOURCE_DIR) / ".." / "shared";
    return std::filesystem::exists(folder / part) ? folder / part : std::filesystem::path();
}

/// Entries of a folder of the measured data for which `wanted` is true, sorted. Empty if the data are missing.
template <class Wanted>
std::vector<std::filesystem::path> shared_entries(const std::string& part, const Wanted& wanted) {
    std::vector<std::filesystem::path> found;
    const std::filesystem::path folder = shared_data(part);
    if (folder.empty()) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (wanted(entry.path())) found.push_back(entry.path());
    // The order of a directory iterator is not defined.
    std::sort(found.begin(), found.end());
    return found;
}

/// Folders of measured experiments.
inline std::vector<std::filesystem::path> shared_experiments() {
    return shared_entries("experiments", [](const std::filesystem::path& path) {
        return std::filesystem::exists(path / "experiment.toml");
    });
}

/// Surfaces of measured bodies (STL).
inline std::vector<std::filesystem::path> shared_bodies() {
    return shared_entries("data/geometry",
                          [](const std::filesystem::path& path) { return path.extension() == ".stl"; });
}

}  // namespace myo::test
