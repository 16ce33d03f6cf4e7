#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace myo {

/// Whole content of a file. Error: missing, a folder, or unreadable.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes to a temporary name beside `path` and renames it, so that a reader never sees half a file.
/// Missing parent folders are made.
Result<void> write_file(const std::filesystem::path& path, std::string_view content);

/// As write_file, for writers that want a path (VTK): `write` gets the temporary path and says whether it succeeded.
Result<void> write_file_with(const std::filesystem::path& path,
                             const std::function<bool(const std::filesystem::path&)>& write);

}  // namespace myo
