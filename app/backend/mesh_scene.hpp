#pragma once

#include <string>

#include "commands/backend.hpp"
#include "project/experiment.hpp"
#include "project/study.hpp"

namespace myo {

/// A set-up for a mesh that comes without an experiment: silicone, held at the lower end of its longest axis, released from
/// its rest shape under gravity (0, 0, -9.81) m/s2 for one second. It has no trials with data.
Experiment mesh_scene_experiment(const SurfaceMesh& surface, const std::string& name);
SceneTrial mesh_scene_trial();
Settings mesh_scene_settings(const Experiment& experiment, const SurfaceMesh& surface);

/// Runs that set-up with the settings in it, on the body that is shown. Errors: it was meshed with other settings; no node at the held end.
Result<RunResult> run_mesh_scene(const Scene& scene, const MeshedBody& body, const Settings& settings, const std::optional<RunExtent>& only,
                                 const Progress& progress);

}  // namespace myo
