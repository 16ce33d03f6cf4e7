#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace myo {

/// Whole content of a file. Error: missing, a folder, or unreadable.
Result<std::string> read_file(const std::filesystem::path& path);

/// "PATH: cannot be written: No space left on device", from the system's error number.
Error not_written(const std::filesystem::path& path, int reason);

/// Where a link leads, also where nothing is there yet; `path` itself when it is no link. Links must not form a loop.
std::filesystem::path behind_links(std::filesystem::path path);

/// Writes a file whole. A plain file is written under a temporary name beside it and renamed, so that a reader never
/// sees half of it; missing parent folders are made. A link stays and what it leads to is written; a device, a pipe
/// and the program's own standard output (/dev/stdout, or the file behind it) are written into.
/// Errors: a folder; else the system's own words, as "cannot be written: No space left on device".
Result<void> write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace myo
