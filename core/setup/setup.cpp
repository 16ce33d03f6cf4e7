#include "setup/setup.hpp"

#include <algorithm>
#include <memory>

#include "base/abandonable.hpp"
#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "effect/changed_body.hpp"
#include "experiment/actuators.hpp"
#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "fibre/switches.hpp"
#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "setup/activation_range.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/first_vibration.hpp"
#include "setup/held_nodes.hpp"
#include "setup/hold_recording.hpp"
#include "setup/marker_noise.hpp"
#include "setup/mesh_suitability.hpp"
#include "setup/muscle_groups.hpp"
#include "setup/obstacles.hpp"
#include "setup/recorded_size.hpp"
#include "setup/recording_frame.hpp"

namespace myo::setup {
namespace {

/// Nodal shares (sum 1) of a load spread over the surface inside a box. `positive` removes negative shares, which
/// clipped quadratic faces can have: a nodal mass must not be negative.
Result<Eigen::VectorXd> surface_share(const experiment::Experiment& experiment, const std::string& key,
                                      const model::Body& body, const Box& box, bool positive) {
    mesh::SurfaceIntegral integral = mesh::surface_weights(body.mesh, body.boundary, box);
    if (!(integral.area > 0.0))
        return experiment::declaration_error(
            experiment, key, "the box holds none of the mesh's surface; choose tetrahedra or a finer resolution");
    if (positive) integral.weight = integral.weight.cwiseMax(0.0);
    return Eigen::VectorXd(integral.weight / integral.weight.sum());
}

// Loads are integrated over the surface of the mesh, so their total is exact for any mesh.
Result<void> add_loads(const Setup& setup, const experiment::TrialDeclaration& trial, model::Model& model) {
    const experiment::Experiment& experiment = setup.experiment;
    for (std::size_t i = 0; i < trial.loads.size(); ++i) {
        const experiment::LoadDeclaration& load = trial.loads[i];
        const bool is_mass = load.kind == experiment::LoadKind::mass;
        const std::string key = experiment::trial_key(experiment, trial) + ".load[" + std::to_string(i) + "].box_m";
        Result<Eigen::VectorXd> share = surface_share(experiment, key, *model.body, box_on_mesh(setup.mesh, load.box_m),
                                                      is_mass);
        if (!share) return share.error();
        if (is_mass)
            model.masses.push_back({std::move(*share), load.mass_kg});
        else
            model.forces.push_back({std::move(*share), load.force_N, load.from_s, load.until_s,
                                    load.curve.value_or(fibre::Signal::constant(1.0))});
    }
    return {};
}

/// Signal of an actuator without steps: recorded, constant, or passive.
fibre::Signal row_signal(const measurement::ActuationTable& table, std::size_t actuator) {
    const Eigen::VectorXd row = table.values.row(static_cast<Eigen::Index>(actuator)).transpose();
    return {{table.time_s.begin(), table.time_s.end()}, {row.begin(), row.end()}};
}

// Order: recorded and constant rows, then steps, then the muscles' own signals, which take precedence over them.
Result<void> add_actuation(const Setup& setup, const experiment::TrialDeclaration& declaration, PreparedTrial& trial) {
    const experiment::Experiment& experiment = setup.experiment;
    const Result<measurement::ActuationTable> table = experiment::read_trial_actuation(experiment, declaration);
    if (!table) return table.error();
    if (!setup.settings.as_published)
        if (const Result<void> positive = check_recorded_activation(experiment, declaration, *table); !positive)
            return positive.error();
    const auto signal_of = [&](const measurement::ActuationTable& rows, std::size_t actuator) {
        for (const experiment::ConstantCommand& command : declaration.constant_commands)
            if (command.curve && command.actuator == rows.muscles[actuator]) return *command.curve;
        return row_signal(rows, actuator);
    };
    const std::size_t muscles = experiment.muscles.size();
    for (std::size_t m = 0; m < muscles; ++m) trial.model.activation.push_back(signal_of(*table, m));
    // Force elements of actuators are the first of the model, see actuator_signals.hpp.
    for (std::size_t c = 0; c < setup.chambers.size(); ++c)
        trial.model.force_elements.push_back(
            chamber_pressure(*setup.body, setup.chambers[c], signal_of(*table, muscles + c)));
    const std::size_t before_tendons = muscles + setup.chambers.size();
    for (std::size_t t = 0; t < setup.tendons.size(); ++t)
        trial.model.force_elements.push_back(tendon_element(setup.tendons[t], signal_of(*table, before_tendons + t)));
    const auto own_signal = [&](std::size_t actuator) {
        return actuator < muscles && experiment.muscles[actuator].signal;
    };
    for (const experiment::ActuationStep& step : declaration.actuation_steps) {
        const std::optional<std::size_t> actuator = experiment::find_actuator(experiment, step.muscle);
        if (!actuator || own_signal(*actuator)) continue;
        set_level(experiment, *actuator, step.level.value_or(passive_level(experiment, *actuator)), trial.model);
        if (!step.level) trial.free_levels.push_back(*actuator);
    }
    declare_activation(experiment, trial.model.activation);
    return {};
}

/// Start, scheme, step and end of the runs of a trial.
void set_time_integration(const Setup& setup, experiment::StartState start, PreparedTrial& trial) {
    trial.options.start = start == experiment::StartState::straight ? dynamics::StartKind::straight
                                                                    : dynamics::StartKind::equilibrium;
    trial.options.integrator = setup.settings.scheme();
    trial.options.solver.strategy = setup.settings.strategy;
    // Provisional step of half a sampling interval; choose_steps() may replace it.
    const Eigen::VectorXd& times = trial.measured.time_s;
    const double interval = sampling_interval_s(trial);
    trial.recorded_activation = trial.model.activation;
    for (const model::ForceElementPointer& element : trial.model.force_elements)
        trial.recorded_commands.push_back(*element->command());
    set_step(trial, setup.settings.h_s.value_or(0.5 * interval));
    // Beyond the last sample, so that a start found a little later still has simulated data under every sample.
    trial.options.end_s = trial.hold ? 0.0 : std::max(times(times.size() - 1), interval) + 3.0 * interval;
}

/// The recording in mesh frame and trial time, with the warnings of reading it.
Result<void> place_recorded(const Setup& setup, const experiment::TrialDeclaration& declaration,
                            const experiment::TrialRecording& read, PreparedTrial& trial,
                            std::vector<std::string>& warnings) {
    if (const Result<void> sized = check_recorded_size(setup.experiment, declaration, setup.surface, read.recording);
        !sized)
        return sized.error();
    warnings.insert(warnings.end(), read.warnings.begin(), read.warnings.end());
    trial.rounding_m = read.rounding_m;
    return place_recording(setup.experiment, declaration, read.recording, trial);
}

Result<PreparedTrial> prepare_trial(const Setup& setup, const model::Model& model,
                                    const experiment::TrialDeclaration& declaration,
                                    std::vector<std::string>& warnings) {
    const experiment::Experiment& experiment = setup.experiment;
    PreparedTrial trial;
    trial.name = declaration.name;
    trial.role = declaration.role;
    trial.hold = declaration.hold;
    trial.model = model;
    if (const Result<void> loads = add_loads(setup, declaration, trial.model); !loads) return loads.error();
    if (const Result<void> activation = add_actuation(setup, declaration, trial); !activation)
        return activation.error();

    // Model first, then data: a trial with an impossible load is rejected before its trace is read.
    Result<experiment::TrialRecording> recording = experiment::read_trial(experiment, declaration);
    if (!recording) return recording.error();
    if (declaration.role != experiment::TrialRole::simulate) {
        if (const Result<void> placed = place_recorded(setup, declaration, *recording, trial, warnings); !placed)
            return placed.error();
    } else {
        trial.occluded_fraction.assign(recording->recording.tracks.size(), 1.0);
        trial.measured = std::move(recording->recording);
        if (experiment.markers.compare == experiment::Comparison::displacement)  // from rest
            for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body)
                trial.reference_m.push_back(marker.rest_m);
    }

    Result<std::vector<SensorSeries>> sensors = read_sensor_series(experiment, declaration, trial.start_s);
    if (!sensors) return sensors.error();
    trial.sensors = std::move(*sensors);
    set_time_integration(setup, declaration.start, trial);
    // After the actuators, whose elements come first.
    for (model::ForceElementPointer& contact : obstacle_contacts(experiment, *setup.body))
        trial.model.force_elements.push_back(std::move(contact));
    return trial;
}

/// Trials without a visible marker are excluded; at least one fit trial must remain, unless none has a recording.
Result<void> check_seen(Setup& setup) {
    bool any = !experiment::has_recordings(setup.experiment);
    for (const PreparedTrial& trial : setup.trials) {
        if (trial.role == experiment::TrialRole::simulate) continue;
        const auto& tracks = trial.measured.tracks;
        const bool seen = std::any_of(tracks.begin(), tracks.end(),
                                      [](const Eigen::Matrix3Xd& track) { return !track.array().isNaN().all(); });
        any = any || (seen && trial.role == experiment::TrialRole::fit);
        if (!seen)
            setup.warnings.push_back("trial " + trial.name + ": no marker was seen in it, so it takes no part");
        else if (trial.measured.sample_count() < 3 && !trial.hold)
            setup.warnings.push_back("trial " + trial.name + ": " + std::to_string(trial.measured.sample_count()) +
                                     " samples contain too little information");
    }
    if (!any) return experiment::declaration_error(setup.experiment, "trial", "no marker was seen in any trial to fit");
    return {};
}

void warn_of_mass(const model::Model& model, std::vector<std::string>& warnings) {
    if (model.mass_model == model::MassModel::consistent) return;
    const double part = model::mass_matrix(model).nodal_kg.sum() / (model.density_kg_m3 * model.body->volume_m3);
    warnings.push_back("equal vertex masses: the body weighs " + format_number(100.0 * part, 3) +
                       " % of its mesh's true mass");
}

/// Default damping time, limited to max_assumed_damping_ratio of the first vibration: zeta = omega d / 2.
///
/// @param model  without muscles, whose activations differ between trials
double assumed_damping_s(const model::Model& model, const SetupSettings& settings) {
    if (settings.assumed_damping_s == 0.0) return 0.0;
    const double omega = first_vibration_rad_s(model);
    if (!(omega > 0.0)) return settings.assumed_damping_s;
    return std::min(settings.assumed_damping_s, 2.0 * settings.max_assumed_damping_ratio / omega);
}

/// Warnings about clocks, frames and the range of activations.
void add_warnings(Setup& setup) {
    const auto add = [&](const std::vector<std::string>& sentences) {
        setup.warnings.insert(setup.warnings.end(), sentences.begin(), sentences.end());
    };
    add(doubtful_frames(setup));
    add(activation_notes(setup));
}

/// The declared law of the material, or the one that the settings name, e.g. for the published formulation.
Result<material::MaterialPointer> chosen_material(const experiment::Experiment& experiment,
                                                  const SetupSettings& settings) {
    const std::string law = settings.material.value_or(experiment.material.model);
    material::MaterialPointer material = material::find_material(
        law, law == experiment.material.model ? experiment.material.law : std::vector<double>{});
    if (!material) return experiment::declaration_error(experiment, "material.model", "no material law '" + law + "'");
    return material;
}

/// Mesh, held body and bound markers.
///
/// @param meshed  mesh to use; null: a new one
Result<void> add_body(Setup& setup, const BodyMesh* meshed, const Progress& progress) {
    const experiment::Experiment& experiment = setup.experiment;
    Result<BodyMesh> mesh = meshed ? *meshed : mesh_of(experiment, setup.surface, setup.settings.mesh, progress);
    if (!mesh) return mesh.error();
    setup.mesh = std::move(*mesh);
    setup.warnings.insert(setup.warnings.end(), setup.mesh.warnings.begin(), setup.mesh.warnings.end());
    const Result<HeldNodes> held = held_nodes(experiment, setup.mesh, mesh::bounding_box(setup.surface.vertices));
    if (!held) return held.error();
    Result<Eigen::MatrixXd> shares = part_shares(experiment, setup.mesh, setup.warnings);
    if (!shares) return shares.error();
    setup.part_shares = std::move(*shares);
    // Effects that vary within a cell need an element that resolves them.
    const bool fine = setup.settings.fine_element || effect::any_varies_within_cells(experiment.effects);
    setup.tendons = find_tendons(experiment, setup.surface, setup.mesh);
    // The tables of a large body take seconds each: a cancelled caller leaves them to end by themselves.
    const auto made = std::make_shared<model::BodyPointer>();
    const bool whole = run_abandonable([made, mesh = setup.mesh.mesh, held = *held,
                                        kind = fine ? fem::fine_element(setup.mesh.element) : setup.mesh.element,
                                        coupled = couplings(setup.tendons)] {
        *made = model::make_body(mesh, kind, held.clamped, coupled, held.guided);
    });
    if (!whole) return Error{"stopped before the body was made", ""};
    setup.body = *made;
    Result<std::vector<Chamber>> chambers = find_chambers(experiment, setup.surface, setup.mesh, *setup.body);
    if (!chambers) return chambers.error();
    setup.chambers = std::move(*chambers);
    // An unsuitable mesh is a warning, not an error: the user may have chosen it on purpose.
    const std::vector<std::string> unfit = unsuitable({setup.surface, setup.mesh, experiment.effects, &setup.chambers});
    setup.warnings.insert(setup.warnings.end(), unfit.begin(), unfit.end());
    // Markers are bound to the surface of the mesh, which may differ slightly from the declared surface.
    std::vector<Eigen::Vector3d> rest;
    for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body) {
        setup.marker_names.push_back(marker.name);
        rest.push_back(marker.rest_m);
    }
    setup.markers = measurement::marker_set(setup.mesh.mesh, rest);
    return {};
}

/// The model that the trials share: body, material and fibres. Only activations and loads differ between trials.
Result<model::Model> shared_model(Setup& setup, const material::MaterialPointer& material) {
    const experiment::Experiment& experiment = setup.experiment;
    model::Model model;
    model.body = setup.body;
    model.material = material;
    set_materials(setup, declared_materials(experiment, 0.0), 1.0, model);
    model.damping_excess_s.clear();
    model.density_kg_m3 = experiment.material.density_kg_m3;
    model.density_factors = density_factors(experiment, setup.part_shares);
    model.mass_model = setup.settings.mass_model;
    warn_of_mass(model, setup.warnings);
    model.velocity_force_1_s = setup.settings.velocity_force_1_s;
    model.gravity_m_s2 = experiment.gravity_m_s2;
    // The assumed damping needs the first vibration, hence a complete model except for the muscles.
    model.damping_s = experiment.material.damping_s ? *experiment.material.damping_s
                                                    : assumed_damping_s(model, setup.settings);
    model.damping_excess_s = damping_excess(experiment, setup.part_shares,
                                            declared_materials(experiment, model.damping_s));
    Result<std::vector<fibre::FibreGroup>> muscles = muscle_groups(experiment, setup.mesh, &setup.warnings);
    if (!muscles) return muscles.error();
    model.fibres = std::make_shared<const std::vector<fibre::FibreGroup>>(std::move(*muscles));
    return model;
}

/// Ranges of the recorded and constant commands over the trials.
std::vector<CommandRange> command_ranges(const std::vector<PreparedTrial>& trials) {
    std::vector<CommandRange> ranges;
    for (const PreparedTrial& trial : trials) {
        ranges.resize(trial.recorded_commands.size());
        for (std::size_t c = 0; c < ranges.size(); ++c)
            for (const double value : trial.recorded_commands[c].values) {
                ranges[c].lowest = std::min(ranges[c].lowest, value);
                ranges[c].highest = std::max(ranges[c].highest, value);
            }
    }
    return ranges;
}

/// The trials with their traces, and the noise of the markers, which is estimated from all of them.
Result<void> add_trials(Setup& setup, const model::Model& model, const Progress& progress) {
    const experiment::Experiment& experiment = setup.experiment;
    std::vector<measurement::Recording> recordings;
    for (const experiment::TrialDeclaration& declaration : experiment.trials) {
        if (progress.cancelled()) return Error{"stopped before trial " + declaration.name + " was read", ""};
        Result<PreparedTrial> trial = prepare_trial(setup, model, declaration, setup.warnings);
        if (!trial) return trial.error();
        recordings.push_back(without_made_samples(declaration, *trial));
        if (trial->hold) trial->measured = mean_pose(trial->measured);
        setup.trials.push_back(std::move(*trial));
    }
    setup.command_ranges = command_ranges(setup.trials);
    if (const Result<void> seen = check_seen(setup); !seen) return seen.error();
    // An effect on the actuation of a body without actuators is declared in vain.
    for (const effect::EffectDeclaration& effect : experiment.effects)
        if (actuator_names(experiment).empty() && effect::find_effect(effect)->kind == effect::EffectKind::actuation)
            setup.warnings.push_back("effect " + effect.id + ": there is no actuator, so it does nothing");
    set_noise(recordings, setup);
    return {};
}

}  // namespace

SetupSettings published_settings() {
    SetupSettings settings;
    settings.mesh.element = fem::ElementKind::hex8_full;
    settings.mesh.voxels = Voxels::truncated;
    settings.integrator = dynamics::Integrator::implicit_euler;
    settings.material = "projective_corotational";
    settings.mass_model = model::MassModel::equal_vertices;
    settings.assumed_damping_s = 0.0;
    settings.as_published = true;
    return settings;
}

double sampling_interval_s(const PreparedTrial& trial) {
    return trial.measured.rate_Hz > 0.0 ? 1.0 / trial.measured.rate_Hz : 0.01;
}

void set_step(PreparedTrial& trial, double h_s) {
    trial.options.h_s = h_s;
    trial.model.activation.clear();
    for (const fibre::Signal& signal : trial.recorded_activation)
        trial.model.activation.push_back(fibre::with_switches_as_jumps(signal, h_s));
    for (std::size_t e = 0; e < trial.recorded_commands.size(); ++e) {
        model::ForceElementPointer& element = trial.model.force_elements[e];
        element = element->with_command(fibre::with_switches_as_jumps(trial.recorded_commands[e], h_s));
    }
}

void check_integration(Setup& setup) {
    const auto shortest = std::min_element(
        setup.trials.begin(), setup.trials.end(),
        [](const PreparedTrial& a, const PreparedTrial& b) { return a.options.h_s < b.options.h_s; });
    setup.integration = check_integration(shortest->model, shortest->options.integrator, shortest->options.h_s);
    const std::vector<std::string>& found = setup.integration->warnings;
    setup.warnings.insert(setup.warnings.end(), found.begin(), found.end());
}

Setup with_fine_element(Setup setup) {
    setup.settings.fine_element = true;
    const fem::ElementKind fine = fem::fine_element(setup.body->kind);
    if (fine == setup.body->kind) return setup;
    // Only the element changes, not the mesh: clamp, markers and loads remain valid.
    setup.body = effect::of_kind(*setup.body, fine);
    for (PreparedTrial& trial : setup.trials) trial.model.body = setup.body;
    return setup;
}

Result<Setup> prepare_setup(const experiment::Experiment& experiment, const SetupSettings& settings,
                            const Progress& progress, const BodyMesh* meshed) {
    Setup setup;
    setup.experiment = experiment;
    setup.settings = settings;
    setup.warnings = experiment.warnings;
    Result<mesh::SurfaceMesh> surface = experiment::read_body_surface(experiment, &setup.warnings);
    if (!surface) return surface.error();
    setup.surface = std::move(*surface);
    if (const Result<void> fits = experiment::check_on_body(experiment, setup.surface); !fits) return fits.error();
    if (!settings.as_published)
        if (const Result<void> positive = check_declared_activation(experiment); !positive) return positive.error();
    const Result<material::MaterialPointer> material = chosen_material(experiment, settings);
    if (!material) return material.error();
    if (const Result<void> meshed_body = add_body(setup, meshed, progress); !meshed_body) return meshed_body.error();
    const Result<model::Model> model = shared_model(setup, *material);
    if (!model) return model.error();
    if (const Result<void> read = add_trials(setup, *model, progress); !read) return read.error();
    add_warnings(setup);
    return setup;
}

}  // namespace myo::setup
