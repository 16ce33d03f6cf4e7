#pragma once

#include <filesystem>
#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

// Edits of the declaration of an experiment; see the functions of the same names in commands/backend.hpp.

Result<ui::commands::Declaration> edited_declaration(const ui::commands::Scene& scene,
                                                     const ui::commands::Declaration& declaration,
                                                     const std::vector<ui::commands::DeclarationEdit>& edits);
Result<ui::commands::Scene> redeclared_scene(const ui::commands::Scene& scene,
                                             const ui::commands::Declaration& declaration,
                                             const ui::commands::MeshedBody* body);
Result<void> write_scene_declaration(const ui::commands::Scene& scene, const ui::commands::Declaration& declaration);
Result<void> write_plain_scene(const std::filesystem::path& folder, const ui::commands::Scene& scene,
                               const ui::commands::Settings& settings);

/// Copies an experiment with its edits into a new folder; see Backend::write_experiment_copy().
/// Errors: the folder is not empty or lies in the experiment, a file cannot be copied.
Result<void> write_scene_copy(const std::filesystem::path& folder, const ui::commands::Scene& scene,
                              const ui::commands::Declaration& declaration);

}  // namespace myo::backend
