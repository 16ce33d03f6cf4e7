#include "backend/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "backend/core_scene.hpp"
#include "backend/fields.hpp"
#include "backend/law_settings.hpp"
#include "base/stopwatch.hpp"
#include "effect/catalogue.hpp"
#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/muscle_groups.hpp"
#include "setup/setup.hpp"

namespace myo::backend {
namespace {

constexpr double release_s = 1.0;  // simulated time

}  // namespace

experiment::Experiment mesh_scene_experiment(const mesh::SurfaceMesh& surface, const std::string& name) {
    experiment::Experiment experiment;
    experiment.name = name;
    experiment.description =
        "Mesh without an experiment: silicone, held at the lower end of its longest axis and released under gravity.";
    const Box bounds = mesh::bounding_box(surface.vertices);
    // The clamp is a thin box at the lower end of the longest axis.
    int axis = 0;
    bounds.size().maxCoeff(&axis);
    // The margin holds the nodes of the end face in spite of rounding.
    const double margin = 1e-3 * bounds.size()(axis);
    experiment.clamp_box_m = {bounds.lowest.array() - margin, bounds.highest.array() + margin};
    experiment.clamp_box_m.highest(axis) = bounds.lowest(axis) + margin;
    experiment.material.model = material::neo_hookean()->id();
    // Soft silicone rubber: nearly incompressible, lightly damped.
    experiment.material.youngs_modulus_Pa = 2.6e5;
    experiment.material.poissons_ratio = 0.49;
    experiment.material.density_kg_m3 = 1070.0;
    experiment.material.damping_s = 0.003;
    return experiment;
}

ui::commands::SceneTrial mesh_scene_trial() {
    // No role, as nothing is measured; times every 10 ms for the time axis of the window.
    return {"release", "", Eigen::VectorXd::LinSpaced(101, 0.0, release_s), {}};
}

ui::commands::Settings mesh_scene_settings(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface) {
    ui::commands::Settings settings;
    settings.element = fem::cell_type(setup::automatic_element(surface));
    settings.resolution_m = setup::automatic_resolution(surface, settings.element);
    settings.material = experiment.material.model;
    settings.youngs_modulus_Pa = experiment.material.youngs_modulus_Pa;
    settings.poissons_ratio = experiment.material.poissons_ratio;
    settings.density_kg_m3 = experiment.material.density_kg_m3;
    settings.damping_s = experiment.material.damping_s.value_or(0.0);
    settings.integrator = to_string(dynamics::Integrator::tr_bdf2);
    // Two steps per displayed time.
    settings.time_step_s = 0.005;
    return settings;
}

namespace {

/// Context for effects in a run without measurement.
effect::TrialContext site_of(const experiment::Experiment& experiment, const model::BodyPointer& body) {
    effect::TrialContext context;
    context.body = body;
    context.held = experiment.clamp_box_m;
    context.actuator_names = setup::actuator_names(experiment);
    context.trial = mesh_scene_trial().name;
    context.end_s = release_s;
    return context;
}

/// The body of the scene with the settings of the window.
///
/// @param held  nodes that are clamped
/// Errors: an unknown material law; those of setup::muscle_groups().
Result<model::Model> scene_model(const experiment::Experiment& experiment, const ui::commands::Settings& settings,
                                 const setup::BodyMesh& mesh, const std::vector<int>& held) {
    model::Model model;
    // Element chosen as in prepare_setup().
    const bool fine = effect::any_varies_within_cells(experiment.effects);
    model.body = model::make_body(mesh.mesh, fine ? fem::fine_element(mesh.element) : mesh.element, held);
    model.material = material::find_material(settings.material, law_values(settings));
    if (!model.material) return Error{"no material law '" + settings.material + "'", "material"};
    model.moduli = model::uniform_moduli(model.body->cell_count(), settings.youngs_modulus_Pa, settings.poissons_ratio);
    model.damping_s = settings.damping_s;
    model.density_kg_m3 = settings.density_kg_m3;
    model.velocity_force_1_s = settings.velocity_force_1_s;
    model.gravity_m_s2 = experiment.gravity_m_s2;
    Result<std::vector<fibre::FibreGroup>> muscles = setup::muscle_groups(experiment, mesh);
    if (!muscles) return muscles.error();
    model.fibres = std::make_shared<const std::vector<fibre::FibreGroup>>(std::move(*muscles));
    // Passive unless a muscle has a signal of its own.
    model.activation.assign(experiment.muscles.size(), fibre::Signal::constant(1.0));
    setup::declare_activation(experiment, model.activation);
    return model;
}

/// The run for the window. Without a recording there is no error: rms values are NaN. An incomplete run has its reason
/// as `problem`.
ui::commands::RunResult shown_release(const dynamics::Trace& trace, model::Model model) {
    ui::commands::RunResult result;
    result.steps = std::max(0.0, static_cast<double>(trace.times_s.size()) - 1.0);
    result.rms_m = std::numeric_limits<double>::quiet_NaN();
    if (!trace.complete()) result.problem = trace.message;
    ui::commands::SimulatedTrial shown;
    shown.name = mesh_scene_trial().name;
    // Every step is a frame; shown_run() thins those of experiments.
    shown.frames = trace.positions;
    shown.frame_time_s = Eigen::Map<const Eigen::VectorXd>(trace.times_s.data(),
                                                           static_cast<Eigen::Index>(trace.times_s.size()));
    shown.rms_m = std::numeric_limits<double>::quiet_NaN();
    result.trials.push_back(std::move(shown));
    auto models = std::make_shared<RunModels>();
    models->trials.push_back(std::move(model));
    result.source = std::move(models);
    return result;
}

}  // namespace

Result<effect::Affected> mesh_scene_release(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                            const ui::commands::Settings& settings) {
    const experiment::Experiment experiment = with_settings(source_of(scene).experiment, settings);
    const setup::SetupSettings setup = setup_settings(settings);
    const setup::BodyMesh* const mesh = shown_mesh(body, settings);
    if (!mesh) return Error{"the body is not meshed with these settings", experiment.name};
    const std::vector<int> held = mesh::nodes_in_box(
        mesh->mesh, setup::held_part(experiment.clamp_box_m, mesh::bounding_box(scene.surface.vertices)));
    if (held.empty()) return Error{"no node lies at the held end; choose a finer resolution", experiment.name};
    Result<model::Model> model = scene_model(experiment, settings, *mesh, held);
    if (!model) return model.error();
    effect::Affected affected{std::move(*model), {}, {}};
    affected.options.integrator = setup.scheme();
    affected.options.h_s = settings.time_step_s;
    affected.options.end_s = release_s;
    // Last: effects change the model and the options as they are.
    effect::apply_effects(site_of(experiment, affected.model.body), experiment.effects, affected);
    return affected;
}

Result<ui::commands::RunResult> run_mesh_scene(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                               const ui::commands::Settings& settings,
                                               const std::optional<ui::commands::RunExtent>& only,
                                               const Progress& progress) {
    Result<effect::Affected> release = mesh_scene_release(scene, body, settings);
    if (!release) return release.error();
    effect::Affected& affected = *release;
    if (only) affected.options.end_s = std::min(only->end_s, release_s);
    const Stopwatch watch;
    const dynamics::Trace trace = dynamics::simulate(affected.model, affected.options, progress);
    const double seconds = watch.seconds();
    // A shortened run serves interaction and skips the check of the integration.
    std::vector<std::string> warnings;
    if (!only)
        warnings = setup::check_integration(affected.model, affected.options.integrator, affected.options.h_s).warnings;
    ui::commands::RunResult result = shown_release(trace, std::move(affected.model));
    result.seconds = seconds;
    result.warnings = std::move(warnings);
    return result;
}

}  // namespace myo::backend
