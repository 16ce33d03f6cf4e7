#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "commands/project.hpp"
#include "toml/toml_path.hpp"

namespace myo::backend {

/// An existing file that a declaration names.
struct NamedFile {
    // Place of the name in the declaration, for with_value().
    toml::TomlPath key;
    std::filesystem::path path;  // resolved
};

/// Existing files that the text of a declaration names: body, parts, masks, signals, recordings, actuation, sensors.
///
/// @param folder  against which the names are resolved
std::vector<NamedFile> named_files(const std::string& text, const std::filesystem::path& folder);

/// Writes `text` as experiment.toml of a folder, with copies of the files that it names. Those inside `from` keep their
/// place; those from elsewhere go into a folder `outside`, and the text names them there.
///
/// @param from  folder of the experiment that the text belongs to
/// @param to    folder to write to; may be `from`, whose own files stay as they are
/// Errors: a file cannot be copied or written.
Result<void> write_contents(const std::filesystem::path& from, const std::string& text,
                            const std::filesystem::path& to);

/// Copies the experiment, with the edits of the project, or the mesh of a project into the project's own folder. An
/// earlier copy is replaced once the new one is complete.
///
/// @param files  folder `<name>.files`
/// @return       the copy: an experiment folder or a mesh file
/// Errors: something cannot be read, copied or written.
Result<std::filesystem::path> put_inside(const ui::commands::Project& project, const std::filesystem::path& files);

}  // namespace myo::backend
