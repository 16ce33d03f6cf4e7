#include "backend/core_scene.hpp"
#include "backend/found_design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "backend/body_actuators.hpp"
#include "backend/check_rows.hpp"
#include "backend/declared_parts.hpp"
#include "backend/dominant_vibration.hpp"
#include "backend/effect_settings.hpp"
#include "backend/law_settings.hpp"
#include "backend/mesh_scene.hpp"
#include "backend/scene_goals.hpp"
#include "backend/scene_setup.hpp"
#include "backend/shown_supports.hpp"
#include "backend/shown_unknowns.hpp"
#include "backend/trial_repairs.hpp"
#include "base/files.hpp"
#include "base/letter_case.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "effect/catalogue.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/boundary_surface.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_parts.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/volume_reader.hpp"
#include "prediction/time_step.hpp"
#include "setup/parts.hpp"

namespace myo::backend {

namespace fs = std::filesystem;
using Eigen::Matrix3Xd;

namespace {

const std::vector<std::string> surface_endings{".stl", ".obj", ".ply", ".vtp"};
const std::vector<std::string> volume_endings{".vtu", ".vtk", ".msh", ".node", ".ele"};

/// Whether the extension is one of these, in any case: ".STL" is as common as ".stl".
bool has_ending(const fs::path& path, const std::vector<std::string>& endings) {
    return std::find(endings.begin(), endings.end(), lower_case(path.extension().string())) != endings.end();
}

/// Muscles of the settings; parts that they leave open are taken from the experiment's muscle of the same origin.
std::vector<experiment::MuscleDeclaration> declared_muscles(const experiment::Experiment& experiment,
                                                            const ui::commands::Settings& settings) {
    std::vector<experiment::MuscleDeclaration> muscles;
    for (const ui::commands::Muscle& muscle : settings.muscles) {
        // A muscle that was made in the window has an empty mask until it is painted.
        experiment::MuscleDeclaration declared{
            muscle.name, experiment::MuscleMask{std::make_shared<const fibre::PaintedMask>(), std::nullopt}, 0.0,
            std::nullopt, std::nullopt};
        for (const experiment::MuscleDeclaration& own : experiment.muscles)
            if (own.name == muscle.declared) declared = own;
        if (muscle.declared.empty()) declared.sought = muscle.sought;
        declared.stiffness_Pa = muscle.stiffness_Pa;
        if (muscle.paint) declared.part = experiment::MuscleMask{muscle.paint, std::nullopt};
        // A muscle either follows another one or has its own signal.
        declared.follows.reset();
        declared.signal.reset();
        if (muscle.follows.empty())
            declared.signal = muscle.signal;
        else
            declared.follows = experiment::FollowsDeclaration{muscle.follows, muscle.ratio};
        muscles.push_back(std::move(declared));
    }
    return muscles;
}

/// Muscles of the experiment before any change.
std::vector<ui::commands::Muscle> shown_muscles(const experiment::Experiment& experiment) {
    std::vector<ui::commands::Muscle> muscles;
    for (const experiment::MuscleDeclaration& declared : experiment.muscles) {
        ui::commands::Muscle muscle;
        muscle.name = muscle.declared = declared.name;
        muscle.color = static_cast<int>(muscles.size());
        muscle.stiffness_Pa = declared.stiffness_Pa;
        muscle.signal = declared.signal;
        if (declared.follows) muscle.follows = declared.follows->muscle, muscle.ratio = declared.follows->ratio;
        muscles.push_back(std::move(muscle));
    }
    return muscles;
}

/// Recording of a marker for display, 3 x T [m], mesh frame. With displacement comparison, measured and simulated
/// curves start from the declared rest position.
Matrix3Xd shown_measurement(const setup::Setup& setup, const setup::PreparedTrial& trial, std::size_t marker) {
    Matrix3Xd shown = trial.measured.tracks[marker];
    if (!trial.reference_m.empty())
        shown.colwise() += Eigen::Vector3d(setup.experiment.markers.on_body[marker].rest_m - trial.reference_m[marker]);
    return shown;
}

/// Markers, trials, settings and vibration of a prepared experiment, as the window displays them.
void fill_from_setup(const setup::Setup& setup, ui::commands::Scene& scene) {
    const experiment::Experiment& experiment = setup.experiment;
    for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body)
        scene.markers.push_back({marker.name, marker.rest_m, marker.label, marker.probe});
    for (const setup::PreparedTrial& trial : setup.trials) {
        ui::commands::SceneTrial shown{trial.name, to_string(trial.role),       trial.measured.time_s, {},
                                       {},         shown_commands(setup, trial)};
        // Trials of the setup are in the order of declaration.
        const experiment::TrialDeclaration& declared = experiment.trials[scene.trials.size()];
        shown.duration_s = declared.duration_s;
        shown.goals = scene_goals(experiment, declared);
        shown.repairs = shown_repairs(declared, trial);
        for (const experiment::LoadDeclaration& load : declared.loads)
            shown.loads.push_back({load.kind == experiment::LoadKind::mass, load.box_m, load.mass_kg, load.force_N,
                                   load.from_s, load.until_s, load.curve});
        for (std::size_t m = 0; m < scene.markers.size(); ++m)
            shown.measured.push_back(shown_measurement(setup, trial, m));
        for (std::size_t m = 0; m < experiment.muscles.size(); ++m)
            shown.activation[experiment.muscles[m].name] = trial.model.activation[m];
        scene.trials.push_back(std::move(shown));
    }
    // The mesh as it was made: the declaration may have left element and edge length to the program.
    scene.settings.element = setup.mesh.mesh.type;
    scene.settings.resolution_m = setup.mesh.resolution_m;
    scene.settings.material = experiment.material.model;
    set_law_values(experiment.material.law, scene.settings);
    scene.settings.youngs_modulus_Pa = experiment.material.youngs_modulus_Pa;
    scene.settings.poissons_ratio = experiment.material.poissons_ratio;
    scene.settings.density_kg_m3 = experiment.material.density_kg_m3;
    // From a model, because an undeclared damping is chosen in prepare_setup().
    scene.settings.damping_s = setup.trials.front().model.damping_s;
    scene.settings.integrator = to_string(setup.settings.integrator);
    // The window displays a single step for all trials.
    scene.settings.time_step_s = prediction::shortest_step_s(setup);
    scene.settings.muscles = shown_muscles(experiment);
    // With the dominant measured vibration the window judges the time step.
    const MeasuredVibration vibration = dominant_vibration(setup);
    scene.frequency_Hz = vibration.frequency_Hz;
    scene.damping_ratio = vibration.damping_ratio;
    scene.fitted = shown_unknowns(setup);
    for (const ui::commands::SceneUnknown& unknown : scene.fitted) scene.calibrated.push_back(unknown.label);
}

}  // namespace

bool is_volume_file(const fs::path& path) { return has_ending(path, volume_endings); }
bool is_mesh_file(const fs::path& path) { return has_ending(path, surface_endings) || is_volume_file(path); }

bool is_experiment(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(path, code) || path.extension() == ".toml";
}

fs::path declaration_file(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(path, code) ? path / "experiment.toml" : path;
}

const SceneSource& source_of(const ui::commands::Scene& scene) {
    return *std::static_pointer_cast<const SceneSource>(scene.source);
}

bool is_mesh_of(const setup::BodyMesh& mesh, const ui::commands::Settings& settings) {
    return mesh.element == fem::default_element(settings.element) && mesh.resolution_m == settings.resolution_m;
}

const setup::BodyMesh* shown_mesh(const ui::commands::MeshedBody& body, const ui::commands::Settings& settings) {
    const auto* const mesh = static_cast<const setup::BodyMesh*>(body.source.get());
    return mesh && is_mesh_of(*mesh, settings) ? mesh : nullptr;
}

setup::MeshRequest mesh_request(const ui::commands::Settings& settings) {
    return {fem::default_element(settings.element), settings.resolution_m};
}

setup::SetupSettings setup_settings(const ui::commands::Settings& settings) {
    setup::SetupSettings result;
    result.mesh = mesh_request(settings);
    // An unknown name leaves the default.
    dynamics::parse_integrator(settings.integrator, result.integrator);
    result.spectral_radius = settings.spectral_radius;
    result.h_s = settings.time_step_s;
    result.material = settings.material;
    result.velocity_force_1_s = settings.velocity_force_1_s;
    result.threads = hardware_threads();
    return result;
}

experiment::Experiment with_settings(experiment::Experiment experiment, const ui::commands::Settings& settings) {
    experiment.material.model = settings.material;
    experiment.material.law = law_values(settings);
    experiment.material.youngs_modulus_Pa = settings.youngs_modulus_Pa;
    experiment.material.poissons_ratio = settings.poissons_ratio;
    experiment.material.density_kg_m3 = settings.density_kg_m3;
    experiment.material.damping_s = settings.damping_s;
    experiment.effects = ui::commands::effects_on(experiment.effects, settings.off);
    for (const ui::commands::AddedEffect& effect : settings.effects) {
        if (effect.off) continue;
        // A project keeps ids and values; the laws are those of the experiment as it is now. A law that was removed
        // since leaves its effect without an entry, and the effect is dropped.
        effect::EffectDeclaration declaration = effect.declaration;
        declaration.law = effect::find_law(declaration.id, experiment.laws);
        if (effect::find_effect(declaration) != nullptr) experiment.effects.push_back(std::move(declaration));
    }
    experiment.muscles = declared_muscles(experiment, settings);
    return experiment;
}

Result<setup::Setup> scene_setup(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                 const ui::commands::Settings& settings, const setup::SetupSettings& chosen,
                                 const Progress& progress) {
    return setup::prepare_setup(with_settings(source_of(scene).experiment, settings), chosen, progress,
                                shown_mesh(body, settings));
}

namespace {

/// Time in the middle of the part of a trial after its start [s]; 0 without samples.
double middle_of(const Eigen::VectorXd& time_s) {
    return time_s.size() > 0 ? 0.5 * std::max(0.0, time_s[time_s.size() - 1]) : 0.0;
}

/// Fills in what a scene shows of a prepared experiment. Lists of the scene are replaced; its path stays.
///
/// @param mesh  mesh to reuse as long as the settings request it; null: none
/// @param text  of the declaration at opening, to which edits are compared
void show_setup(const setup::Setup& setup, std::shared_ptr<const setup::BodyMesh> mesh,
                std::shared_ptr<const std::string> text, ui::commands::Scene& scene) {
    const experiment::Experiment& experiment = setup.experiment;
    scene.name = experiment.name;
    scene.description = experiment.description;
    scene.surface = setup.surface;
    scene.clamp_m = experiment.clamp_box_m;
    scene.supports = shown_supports(experiment);
    scene.gravity_m_s2 = experiment.gravity_m_s2;
    scene.is_experiment = true;
    scene.unknowns = experiment.material.calibrate;
    scene.declared = declared_parts(setup);
    scene.regions.clear();
    for (const int number : setup.mesh.mesh.regions) ++scene.regions[number];
    scene.warnings = setup.warnings;
    scene.checks = check_rows(check::check_before(setup));
    scene.markers.clear();
    scene.trials.clear();
    scene.calibrated.clear();
    fill_from_setup(setup, scene);
    scene.seekable = seek_choices(experiment);
    // A new effect that is an event is offered in the middle of the first trial, where it can be seen.
    show_declared(experiment, setup.surface, middle_of(setup.trials.front().measured.time_s), scene);
    scene.source = std::make_shared<const SceneSource>(
        SceneSource{experiment, setup.surface, std::move(mesh), std::move(text)});
}

}  // namespace

Result<ui::commands::Scene> open_experiment(const fs::path& path, const Progress& progress) {
    const Result<experiment::Experiment> experiment = experiment::read_experiment(path);
    if (!experiment) return experiment.error();
    // Edits of the window change this text, so that comments and order of the file survive.
    Result<std::string> text = read_file(declaration_file(path));
    if (!text) return text.error();
    setup::SetupSettings settings;
    settings.threads = hardware_threads();
    const Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings, progress);
    if (!setup) return setup.error();
    ui::commands::Scene scene;
    scene.path = path;
    show_setup(*setup, std::make_shared<const setup::BodyMesh>(setup->mesh),
               std::make_shared<const std::string>(std::move(*text)), scene);
    return scene;
}

Result<ui::commands::Scene> scene_of(const ui::commands::Scene& scene, const experiment::Experiment& experiment,
                                     const ui::commands::MeshedBody* body) {
    const SceneSource& source = source_of(scene);
    const auto* const shown = body ? static_cast<const setup::BodyMesh*>(body->source.get()) : source.mesh.get();
    setup::SetupSettings settings;
    settings.threads = hardware_threads();
    // An edited support may lie where the shown mesh has no nodes; only then is meshing worth its time on the UI
    // thread.
    Result<setup::Setup> setup = setup::prepare_setup(experiment, settings, {}, shown);
    if (!setup && shown) setup = setup::prepare_setup(experiment, settings, {});
    if (!setup) return setup.error();
    ui::commands::Scene result = scene;
    // A mesh follows the box that holds the body and those of parts, so that of other boxes is not kept.
    const bool same_boxes = mesh_boxes(experiment) == mesh_boxes(source.experiment);
    show_setup(*setup, same_boxes ? source.mesh : nullptr, source.text, result);
    // show_setup() has set declared values, which would undo what the user has set.
    result.settings = scene.settings;
    return result;
}

namespace {

/// A body without experiment, with the default set-up of a mesh.
ui::commands::Scene plain_scene(const fs::path& path, mesh::SurfaceMesh surface) {
    ui::commands::Scene scene;
    scene.path = path;
    scene.name = path.stem().string();
    scene.surface = std::move(surface);
    const experiment::Experiment experiment = mesh_scene_experiment(scene.surface, scene.name);
    scene.description = experiment.description;
    scene.clamp_m = experiment.clamp_box_m;
    scene.gravity_m_s2 = experiment.gravity_m_s2;
    scene.trials.push_back(mesh_scene_trial());
    show_declared(experiment, scene.surface, 0.0, scene);
    scene.settings = mesh_scene_settings(experiment, scene.surface);
    scene.source = std::make_shared<const SceneSource>(SceneSource{experiment, scene.surface, nullptr});
    return scene;
}

/// Scene of a volume mesh; its boundary becomes the surface. Errors: those of the reader, an implausible size.
Result<ui::commands::Scene> open_volume(const fs::path& path, double metres_per_unit) {
    Result<mesh::VolumeMesh> read = mesh::read_volume(path, metres_per_unit);
    if (!read) return read.error();
    if (const Result<void> size = mesh::check_plausible_size(mesh::bounding_box(read->nodes).size()); !size)
        return Error{size.error().what, path.string()};
    ui::commands::Scene scene = plain_scene(path, mesh::boundary_surface(*read));
    scene.settings.element = read->type;
    // Equal to the resolution of the kept mesh below, so that is_mesh_of() finds it to match.
    scene.settings.resolution_m = mesh::mean_edge_length(*read);
    SceneSource source = source_of(scene);
    // A volume mesh is kept as it is until the settings request another element or edge length.
    source.mesh = std::make_shared<const setup::BodyMesh>(setup::BodyMesh{
        std::move(*read), fem::default_element(scene.settings.element), scene.settings.resolution_m, std::nullopt, {}});
    scene.source = std::make_shared<const SceneSource>(std::move(source));
    return scene;
}

}  // namespace

Result<ui::commands::Scene> open_mesh(const fs::path& path, std::optional<double> metres_per_unit) {
    if (!is_mesh_file(path))
        return Error{"is no experiment, project or mesh by its ending; surfaces: " + join(surface_endings, " ") +
                         ", volumes: " + join(volume_endings, " "),
                     path.string()};
    if (!metres_per_unit) return Error{"the file does not say its unit; choose m or mm", path.string()};
    if (is_volume_file(path)) return open_volume(path, *metres_per_unit);
    std::vector<std::string> warnings;
    const Result<mesh::SurfaceMesh> read = mesh::read_surface(path, *metres_per_unit, Eigen::Matrix3d::Identity(),
                                                              &warnings);
    if (!read) return read.error();
    // Unlike an experiment, a mesh that is oriented inward is accepted and flipped.
    const mesh::SurfaceMesh surface = mesh::weld(*read);
    const mesh::SurfaceReport report = mesh::check_surface(surface);
    if (const Result<void> size = mesh::check_plausible_size(report.size); !size)
        return Error{size.error().what, path.string()};
    if (!report.closed) return Error{"the surface is not closed: " + join(report.messages), path.string()};
    const Result<mesh::FacingParts> parts = mesh::facing_parts(report.outward ? surface : mesh::flipped(surface));
    if (!parts) return Error{parts.error().what, path.string()};
    ui::commands::Scene scene = plain_scene(path, parts->surface);
    warnings.insert(warnings.end(), report.messages.begin(), report.messages.end());
    warnings.insert(warnings.end(), parts->notes.begin(), parts->notes.end());
    scene.warnings = warnings;
    return scene;
}

}  // namespace myo::backend
