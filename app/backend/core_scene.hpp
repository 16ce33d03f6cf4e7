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
    std::shared_ptr<const StudyMesh> mesh = {};   // with which it was opened; null: none
};
const SceneSource& source_of(const Scene& scene);

/// Whether it is what these settings ask for.
bool is_mesh_of(const StudyMesh& mesh, const Settings& settings);
/// The mesh that is shown, where these settings ask for no other; else null.
const StudyMesh* shown_mesh(const MeshedBody& body, const Settings& settings);

MeshRequest mesh_request(const Settings& settings);
StudySettings study_settings(const Settings& settings);

/// The experiment with the settings' values, effects and muscles in it.
Experiment with_settings(Experiment experiment, const Settings& settings);

/// The scene's study with these settings, on the mesh that is shown where it is theirs.
Result<Study> scene_study(const Scene& scene, const MeshedBody& body, const Settings& settings, const StudySettings& chosen, const Progress& progress);


/// Whether a path names an experiment and not a mesh.
bool is_experiment(const std::filesystem::path& path);
/// Whether a file is a surface or a volume mesh, by its ending; whether it is a volume mesh.
bool is_mesh_file(const std::filesystem::path& path);
bool is_volume_file(const std::filesystem::path& path);

/// A volume mesh keeps its own elements as long as the settings ask for no others.
/// Errors: those of the schema; of the mesh readers, an ending that they do not know, a surface that is not closed, an implausible size.
Result<Scene> open_experiment(const std::filesystem::path& path, const Progress& progress);
Result<Scene> open_mesh(const std::filesystem::path& path, std::optional<double> metres_per_unit);

}  // namespace myo
