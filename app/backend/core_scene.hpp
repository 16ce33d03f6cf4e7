#pragma once

#include <filesystem>
#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"
#include "experiment/experiment.hpp"
#include "setup/setup.hpp"

// Experiments and meshes of the core as scenes of the workbench, and settings of the workbench as declarations of the
// core.

namespace myo::backend {

/// What a scene was opened from.
struct SceneSource {
    experiment::Experiment experiment;
    mesh::SurfaceMesh surface;
    std::shared_ptr<const setup::BodyMesh> mesh = {};  // with which it was opened; null: none
};
const SceneSource& source_of(const ui::commands::Scene& scene);

/// Whether it is what these settings ask for.
bool is_mesh_of(const setup::BodyMesh& mesh, const ui::commands::Settings& settings);
/// The mesh that is shown, where these settings ask for no other; else null.
const setup::BodyMesh* shown_mesh(const ui::commands::MeshedBody& body, const ui::commands::Settings& settings);

setup::MeshRequest mesh_request(const ui::commands::Settings& settings);
setup::SetupSettings setup_settings(const ui::commands::Settings& settings);

/// The experiment with the settings' values, effects and muscles in it.
experiment::Experiment with_settings(experiment::Experiment experiment, const ui::commands::Settings& settings);

/// The scene's setup with these settings, on the mesh that is shown where it is theirs.
Result<setup::Setup> scene_setup(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                 const ui::commands::Settings& settings, const setup::SetupSettings& chosen,
                                 const Progress& progress);

/// Whether a path names an experiment and not a mesh.
bool is_experiment(const std::filesystem::path& path);
/// Whether a file is a surface or a volume mesh, by its ending; whether it is a volume mesh.
bool is_mesh_file(const std::filesystem::path& path);
bool is_volume_file(const std::filesystem::path& path);

/// A volume mesh keeps its own elements as long as the settings ask for no others.
/// Errors: those of the schema; of the mesh readers, an ending that they do not know, a surface that is not closed, an
/// implausible size.
Result<ui::commands::Scene> open_experiment(const std::filesystem::path& path, const Progress& progress);
Result<ui::commands::Scene> open_mesh(const std::filesystem::path& path, std::optional<double> metres_per_unit);

}  // namespace myo::backend
