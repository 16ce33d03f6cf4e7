#pragma once

#include <filesystem>
#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

// Edits of the declaration of an experiment, as text: comments and order of the file survive. Methods of Backend of
// similar names (ui/commands/backend.hpp) call these functions.

/// The declaration with further edits, applied in order.
///
/// @param declaration  the edits so far; without a text: the file as it was opened
/// Errors: an edit that does not fit the text, such as one of a missing element. Whether the result is a valid
/// experiment is not checked; redeclared_scene() does.
Result<ui::commands::Declaration> edited_declaration(const ui::commands::Scene& scene,
                                                     const ui::commands::Declaration& declaration,
                                                     const std::vector<ui::commands::DeclarationEdit>& edits);
/// The scene with an edited declaration; see scene_of() for its mesh and settings.
///
/// Errors: those of read_experiment_text() and scene_of(), without a place: their lines are in no file.
Result<ui::commands::Scene> redeclared_scene(const ui::commands::Scene& scene,
                                             const ui::commands::Declaration& declaration,
                                             const ui::commands::MeshedBody* body);
/// Replaces the experiment's own file by the edited text. Errors: the file cannot be written.
Result<void> write_scene_declaration(const ui::commands::Scene& scene, const ui::commands::Declaration& declaration);
/// Writes a plain mesh with the settings as an experiment whose trial is only simulated.
///
/// Errors: those of experiment::write_planned_experiment().
Result<void> write_plain_scene(const std::filesystem::path& folder, const ui::commands::Scene& scene,
                               const ui::commands::Settings& settings);

/// Copies an experiment with its edits into a new folder; see Backend::write_experiment_copy().
/// Errors: the folder is not empty or lies in the experiment, a file cannot be copied.
Result<void> write_scene_copy(const std::filesystem::path& folder, const ui::commands::Scene& scene,
                              const ui::commands::Declaration& declaration);

}  // namespace myo::backend
