#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "commands/project.hpp"

namespace myo::backend {

/// Writes a project as TOML that a person can read and edit. Masks of painted muscles become tables of their own in
/// `<name>.files` beside it, named after what is in them, so that an interrupted save leaves the project as it was.
/// Masks of the save before are removed unless another project beside it, as a backup, names them. Errors: a file
/// cannot be written.
Result<void> write_project_file(const std::filesystem::path& file, const ui::commands::Project& project);

/// Errors, with line or key: those of TOML, another schema, unknown keys, values out of their range, muscles of one
/// name, broken masks. A mask that is not there is a warning, and its muscle has no paint.
Result<ui::commands::Project> read_project_file(const std::filesystem::path& file);

}  // namespace myo::backend
