#pragma once

#include <filesystem>
#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"
#include "experiment/experiment.hpp"
#include "setup/setup.hpp"

// Conversion between the core and the workbench: experiments and meshes become scenes, settings of the window become
// declarations.

namespace myo::backend {

/// Core objects that a scene was opened from. Shared read-only by all copies of the scene.
struct SceneSource {
    // As declared, with the edits of the declaration but without the settings of the window; see with_settings().
    experiment::Experiment experiment;
    // Surface of the body, closed, outward [m].
    mesh::SurfaceMesh surface;
    std::shared_ptr<const setup::BodyMesh> mesh = {};  // mesh at opening; null: none
    std::shared_ptr<const std::string> text = {};      // of an experiment's declaration at opening
};
/// Source of a scene; every scene of this backend has one, a scene of another backend must not be given.
const SceneSource& source_of(const ui::commands::Scene& scene);

/// Whether a mesh has the element and edge length of the settings. Edge lengths are compared exactly: they are copied
/// from mesh to settings, not computed.
bool is_mesh_of(const setup::BodyMesh& mesh, const ui::commands::Settings& settings);
/// The displayed mesh if it has the element and edge length of the settings, else null.
const setup::BodyMesh* shown_mesh(const ui::commands::MeshedBody& body, const ui::commands::Settings& settings);

/// Element and edge length [m] of the settings, as prepare_setup() takes them.
setup::MeshRequest mesh_request(const ui::commands::Settings& settings);
/// Simulation settings of the core from those of the window; uses all hardware threads.
///
/// The step is a request: commands that may choose their own reset `h_s` where the user did not set it. An unknown
/// integrator, as from a project of a later version, leaves the default one.
setup::SetupSettings setup_settings(const ui::commands::Settings& settings);

/// The experiment with material values, effects and muscles of the settings.
///
/// Switched-off effects are left out, added ones appended after those of the file. An added effect whose id the
/// catalogue and the experiment's laws do not know is left out.
experiment::Experiment with_settings(experiment::Experiment experiment, const ui::commands::Settings& settings);

/// Setup of a scene with these settings; reuses the displayed mesh if it matches.
///
/// @param chosen  simulation settings, usually setup_settings() with a modified step
/// Errors: those of prepare_setup().
Result<setup::Setup> scene_setup(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                 const ui::commands::Settings& settings, const setup::SetupSettings& chosen,
                                 const Progress& progress);

/// Whether a path is an experiment: a folder or a .toml file. The content is not read.
bool is_experiment(const std::filesystem::path& path);
/// Whether a file is a surface or volume mesh, or a volume mesh, by its extension.
bool is_mesh_file(const std::filesystem::path& path);
bool is_volume_file(const std::filesystem::path& path);

/// File of an experiment that is opened by its folder or by the file itself.
std::filesystem::path declaration_file(const std::filesystem::path& path);
/// Opens an experiment as a scene. Errors: those of read_experiment() and prepare_setup().
Result<ui::commands::Scene> open_experiment(const std::filesystem::path& path, const Progress& progress);
/// An opened scene with another experiment of the same body; its settings stay.
///
/// The shown mesh, or that of the scene, serves if the experiment can be prepared on it; otherwise a new one is made.
/// @param body  shown mesh; null: none
/// Errors: those of prepare_setup().
Result<ui::commands::Scene> scene_of(const ui::commands::Scene& scene, const experiment::Experiment& experiment,
                                     const ui::commands::MeshedBody* body);
/// Opens a surface or volume mesh as a scene. A volume mesh keeps its elements until the settings request others.
///
/// @param metres_per_unit  unit of the file, which meshes do not store; empty: not chosen yet, an error
/// Errors: no unit, those of the mesh readers, an unknown extension, a surface that is not closed, an implausible size.
Result<ui::commands::Scene> open_mesh(const std::filesystem::path& path, std::optional<double> metres_per_unit);

}  // namespace myo::backend
