#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace myo::test {

/// A file or folder of the measured data, which lie in MYOLOOP_DATA or beside the checkout; empty where it is not
/// there.
inline std::filesystem::path shared_data(const std::string& part) {
    const char* const named = std::getenv("MYOLOOP_DATA");
    const std::filesystem::path folder = named != nullptr ? std::filesystem::path(named)
                                                          : std::filesystem::path(MYOLOOP_SOURCE_DIR) / ".." / "shared";
    return std::filesystem::exists(folder / part) ? folder / part : std::filesystem::path();
}

/// What of a folder of the measured data is wanted, sorted; empty where the data are not there.
template <class Wanted>
std::vector<std::filesystem::path> shared_entries(const std::string& part, const Wanted& wanted) {
    std::vector<std::filesystem::path> found;
    const std::filesystem::path folder = shared_data(part);
    if (folder.empty()) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (wanted(entry.path())) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

inline std::vector<std::filesystem::path> shared_experiments() {
    return shared_entries("experiments", [](const std::filesystem::path& path) {
        return std::filesystem::exists(path / "experiment.toml");
    });
}

inline std::vector<std::filesystem::path> shared_bodies() {
    return shared_entries("data/geometry",
                          [](const std::filesystem::path& path) { return path.extension() == ".stl"; });
}

}  // namespace myo::test
