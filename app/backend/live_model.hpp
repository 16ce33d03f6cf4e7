#pragma once

#include <memory>

#include "commands/backend.hpp"

namespace myo::backend {

/// Model of a trial that plays live, with the material, muscles, effects and step of the settings.
///
/// @param trial   index in the scene's trials
/// @param before  model that played before: if it has the same mesh, the new one goes on where that is; null: none
/// @param body    displayed mesh; nodes of a grip are numbered in it
/// Errors: those of scene_setup() or mesh_scene_release(); no start state; cancelled.
Result<std::unique_ptr<ui::commands::LiveModel>> make_live_model(
    const ui::commands::Scene& scene, const ui::commands::MeshedBody& body, const ui::commands::Settings& settings,
    std::size_t trial, const ui::commands::LiveModel* before, const Progress& progress);

}  // namespace myo::backend
