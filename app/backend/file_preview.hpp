#pragma once

#include <filesystem>
#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// Summary of a file or folder before it is opened.
///
/// Declarations of experiments and projects; size and elements of meshes; markers, frames, rate and duration of
/// recordings. For large files only the size is given, so that browsing stays fast. Empty if unknown.
std::vector<ui::commands::ReportLine> preview_of(const std::filesystem::path& path);

}  // namespace myo::backend
