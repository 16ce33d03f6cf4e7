#pragma once

#include <filesystem>
#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"
#include "project/experiment.hpp"
#include "project/study.hpp"

// Experiments and meshes of the core as scenes of the workbench, and settings of the workbench as declarations of the core.

namespace myo {

/// What a scene was opened from.
struct SceneSource {
    Experiment experiment;
    SurfaceMesh surface;
};
const SceneSource& source_of(const Scene& scene);

MeshRequest mesh_request(const Settings& settings);
StudySettings study_settings(const Settings& settings);

/// The experiment with the settings' values, effects and muscles in it.
Experiment with_settings(Experiment experiment, const Settings& settings);

/// Whether a path names an experiment and not a mesh.
bool is_experiment(const std::filesystem::path& path);

/// Errors: those of the schema; of the mesh readers, a surface that is not closed, an implausible size.
Result<Scene> open_experiment(const std::filesystem::path& path, const Progress& progress);
Result<Scene> open_mesh(const std::filesystem::path& path, std::optional<double> metres_per_unit);

}  // namespace myo
