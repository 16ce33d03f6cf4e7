#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "commands/project.hpp"

namespace myo::backend {

/// Writes a project as TOML that can be edited by hand.
///
/// Painted masks become tables in the folder `<name>.files`, named by their content, so that an interrupted save leaves
/// the old project intact. Masks of the previous save are removed unless another project in the folder references them.
/// Errors: a file cannot be written.
Result<void> write_project_file(const std::filesystem::path& file, const ui::commands::Project& project);

/// Reads a project.
///
/// Errors, with line or key: those of TOML, another schema, unknown keys, values out of range, duplicate muscle names,
/// damaged masks. A missing mask is a warning, and its muscle has no paint.
Result<ui::commands::Project> read_project_file(const std::filesystem::path& file);

}  // namespace myo::backend
