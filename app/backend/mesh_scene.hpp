#pragma once

#include <string>

#include "commands/backend.hpp"
#include "experiment/experiment.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// A set-up for a mesh that comes without an experiment: silicone, held at the lower end of its longest axis, released
/// from its rest shape under gravity (0, 0, -9.81) m/s2 for one second. It has no trials with data.
experiment::Experiment mesh_scene_experiment(const mesh::SurfaceMesh& surface, const std::string& name);
ui::commands::SceneTrial mesh_scene_trial();
ui::commands::Settings mesh_scene_settings(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface);

/// Runs that set-up with the settings in it, on the body that is shown. Errors: it was meshed with other settings; no
/// node at the held end.
Result<ui::commands::RunResult> run_mesh_scene(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                               const ui::commands::Settings& settings,
                                               const std::optional<ui::commands::RunExtent>& only,
                                               const Progress& progress);

}  // namespace myo::backend
