#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace myo {

/// Content of a file as one string. Errors: the file is missing, is a folder or cannot be read.
Result<std::string> read_file(const std::filesystem::path& path);

/// Error of a failed write, for example "PATH: cannot be written: No space left on device".
/// @param reason  errno of the failed call
Error not_written(const std::filesystem::path& path, int reason);

/// Target of a chain of symbolic links; the target need not exist.
/// @return  `path` itself if it is not a link. The links must not form a loop.
std::filesystem::path behind_links(std::filesystem::path path);

/// Replaces the content of a file.
///
/// A regular file is written under a temporary name in the same folder and renamed, so that a concurrent reader never
/// sees partial content; missing parent folders are created. A symbolic link is kept and its target is written.
/// Devices, pipes and the standard output of this process (/dev/stdout or the file it is redirected to) are written in
/// place.
/// Errors: the path is a folder; otherwise the system's message, for example "cannot be written: No space left on
/// device".
Result<void> write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace myo
