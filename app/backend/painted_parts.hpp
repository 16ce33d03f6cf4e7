#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "commands/declaration.hpp"
#include "experiment/experiment.hpp"
#include "toml/toml_reader.hpp"

// Masks of parts that were painted in the window: in memory until the experiment or project is written.

namespace myo::backend {

/// The text with a part given by a mask, whose file gets a name made from its content. The mask is added to `painted`.
///
/// Errors: there is no such part.
Result<std::string> with_painted_part(const std::string& text, const ui::commands::PaintDeclared& edit,
                                      ui::commands::Declaration& painted);

/// Puts masks of the declaration in the place of their files, which need not be there yet.
///
/// @param folder  of the experiment
void give_masks(const ui::commands::Declaration& declaration, const std::filesystem::path& folder,
                experiment::Experiment& experiment);

/// Writes the masks that the text of a declaration names and that are not in the folder of the experiment yet.
///
/// Errors: a file cannot be written.
Result<void> write_masks(const ui::commands::Declaration& declaration, const std::filesystem::path& folder);

/// Writes the masks of a declaration into the folder of a project.
///
/// @param files  folder `<name>.files`
/// @param used   receives the names of the files
/// @return       text of the project that names them
/// Errors: a file cannot be written.
Result<std::string> project_text_of_masks(const ui::commands::Declaration& declaration,
                                          const std::filesystem::path& files, std::set<std::string>& used);

/// Reads the masks that a project names. Throws TomlFailure.
///
/// @param folder    of the project
/// @param warnings  receives missing masks
std::map<std::string, std::shared_ptr<const fibre::PaintedMask>> read_project_parts(const toml::TomlReader& document,
                                                                                    const std::filesystem::path& folder,
                                                                                    std::vector<std::string>& warnings);

}  // namespace myo::backend
