#pragma once

#include <string>

#include "commands/backend.hpp"
#include "effect/effect.hpp"
#include "experiment/experiment.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// Default set-up of a mesh without experiment: silicone, clamped at the lower end of its longest axis, released from
/// the rest shape under gravity (0, 0, -9.81) m/s2 for one second. It has no trials with data.
experiment::Experiment mesh_scene_experiment(const mesh::SurfaceMesh& surface, const std::string& name);
/// The displayed trial of this set-up: "release", no role, no markers, times from 0 to 1 s.
ui::commands::SceneTrial mesh_scene_trial();
/// Initial settings of the window for this set-up, with the default mesh of the surface.
ui::commands::Settings mesh_scene_settings(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface);

/// Model and options of the run of this set-up, with the settings and on the displayed mesh.
///
/// Errors: the mesh belongs to other settings; no node at the clamped end; an unknown material law.
Result<effect::Affected> mesh_scene_release(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                            const ui::commands::Settings& settings);

/// Simulates the release and gives the motion of every step; a cancelled run has the steps so far.
///
/// @param only  limits the simulated time, its trial index is not used; empty: all, with the check of the integration
/// Errors: those of mesh_scene_release().
Result<ui::commands::RunResult> run_mesh_scene(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                               const ui::commands::Settings& settings,
                                               const std::optional<ui::commands::RunExtent>& only,
                                               const Progress& progress);

}  // namespace myo::backend
