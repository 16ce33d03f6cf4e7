#pragma once

#include <filesystem>
#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// What is known of a file before it is opened: of experiments and projects what they declare, of meshes their size and
/// elements, of recordings their markers, frames, rate and duration. Empty when nothing. Of large files only their
/// size, so that choosing goes on.
std::vector<ui::commands::ReportLine> preview_of(const std::filesystem::path& path);

}  // namespace myo::backend
