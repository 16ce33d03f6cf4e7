#include "project/study.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "effect/changed_body.hpp"
#include "fibre/switches.hpp"
#include "material/catalogue.hpp"
#include "measurement/noise.hpp"
#include "mesh/region.hpp"
#include "project/activation_range.hpp"
#include "project/check_body.hpp"
#include "project/first_vibration.hpp"
#include "project/mesh_suitability.hpp"
#include "project/muscle_groups.hpp"
#include "project/read_experiment.hpp"
#include "project/read_trial.hpp"
#include "project/study_frames.hpp"

namespace myo {
namespace {

/// Shares of a total over the surface inside a box, and the same without negative nodal shares (a clipped quadratic face has
/// some), as a mass must be.
Result<Eigen::VectorXd> surface_share(const Experiment& experiment, const std::string& key, const Body& body, const Box& box,
                                      bool positive) {
    SurfaceIntegral integral = surface_weights(body.mesh, body.boundary, box);
    if (!(integral.area > 0.0))
        return declaration_error(experiment, key, "the box holds none of the mesh's surface; choose tetrahedra or a finer resolution");
    if (positive) integral.weight = integral.weight.cwiseMax(0.0);
    return Eigen::VectorXd(integral.weight / integral.weight.sum());
}

Result<void> add_loads(const Study& study, const TrialDeclaration& trial, Model& model) {
    const Experiment& experiment = study.experiment;
    for (std::size_t i = 0; i < trial.loads.size(); ++i) {
        const LoadDeclaration& load = trial.loads[i];
        const bool is_mass = load.kind == LoadKind::mass;
        const std::string key = trial_key(experiment, trial) + ".load[" + std::to_string(i) + "].box_m";
        Result<Eigen::VectorXd> share = surface_share(experiment, key, *model.body, box_on_mesh(study.mesh, load.box_m), is_mass);
        if (!share) return share.error();
        if (is_mass) model.masses.push_back({std::move(*share), load.mass_kg});
        else model.forces.push_back({std::move(*share), load.force_N, load.from_s, load.until_s});
    }
    return {};
}

Result<void> add_activation(const Study& study, const TrialDeclaration& declaration, StudyTrial& trial) {
    const Experiment& experiment = study.experiment;
    const Result<ActuationTable> table = read_trial_actuation(experiment, declaration);
    if (!table) return table.error();
    if (!study.settings.as_published)
        if (const Result<void> positive = check_recorded_activation(experiment, declaration, *table); !positive)
            return positive.error();
    for (std::size_t m = 0; m < experiment.muscles.size(); ++m) {
        Signal signal = Signal::constant(1.0);
        if (table->time_s.size() > 0) {
            signal.times_s.assign(table->time_s.begin(), table->time_s.end());
            const Eigen::VectorXd row = table->values.row(static_cast<Eigen::Index>(m)).transpose();
            signal.values.assign(row.begin(), row.end());
        }
        trial.model.activation.push_back(std::move(signal));
    }
    for (const ActuationStep& step : declaration.actuation_steps)
        for (std::size_t m = 0; m < experiment.muscles.size(); ++m) {
            if (experiment.muscles[m].name != step.muscle || experiment.muscles[m].signal) continue;
            trial.model.activation = with_level(experiment, trial.model.activation, m, step.level.value_or(1.0));
            if (!step.level) trial.free_levels.push_back(m);
        }
    declare_activation(experiment, trial.model.activation);
    return {};
}

Result<StudyTrial> prepare_trial(const Study& study, const Model& model, const TrialDeclaration& declaration,
                                 std::vector<std::string>& warnings) {
    const Experiment& experiment = study.experiment;
    StudyTrial trial;
    trial.name = declaration.name;
    trial.role = declaration.role;
    trial.model = model;
    if (const Result<void> loads = add_loads(study, declaration, trial.model); !loads) return loads.error();
    if (const Result<void> activation = add_activation(study, declaration, trial); !activation)
        return activation.error();

    Result<TrialRecording> recording = read_trial(experiment, declaration);
    if (!recording) return recording.error();
    warnings.insert(warnings.end(), recording->warnings.begin(), recording->warnings.end());
    trial.rounding_m = recording->rounding_m;
    if (const Result<void> framed = place_recording(experiment, declaration, recording->recording, trial); !framed) return framed.error();

    trial.options.start = declaration.start == StartState::straight ? StartKind::straight : StartKind::equilibrium;
    trial.options.integrator = study.settings.scheme();
    trial.options.solver.strategy = study.settings.strategy;
    const Eigen::VectorXd& times = trial.measured.time_s;
    const double interval = sampling_interval_s(trial);
    trial.recorded_activation = trial.model.activation;
    set_step(trial, study.settings.h_s.value_or(0.5 * interval));
    // One step beyond the last sample, so that a start found a little later still has data under every sample.
    trial.options.end_s = std::max(times(times.size() - 1), interval) + 3.0 * interval;
    return trial;
}

/// Noise per marker: declared, or estimated in each trial and pooled. Where it cannot be estimated it is the others'. Never less than what rounding makes.
void set_noise(const std::vector<Recording>& recordings, Study& study) {
    const auto count = static_cast<Eigen::Index>(study.marker_names.size());
    const auto coarsest = std::max_element(study.trials.begin(), study.trials.end(), [](const StudyTrial& a, const StudyTrial& b) { return a.rounding_m < b.rounding_m; });
    const double rounded_m = rounding_deviation(coarsest->rounding_m);
    if (const auto declared = study.experiment.markers.noise_m) {
        study.noise_m = Eigen::VectorXd::Constant(count, std::max(*declared, rounded_m));
        if (rounded_m > *declared)
            study.warnings.push_back("markers.noise_m: the numbers of trial " + coarsest->name + " are rounded to " + format_number(1e3 * coarsest->rounding_m) + " mm, which is noise of " +
                                     format_number(1e3 * rounded_m, 3) + " mm by itself; it is taken in place of the " + format_number(1e3 * *declared, 3) + " mm declared");
        return;
    }
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), found = Eigen::VectorXd::Zero(count);
    for (const Recording& recording : recordings)
        for (Eigen::Index m = 0; m < count; ++m) {
            const NoiseEstimate estimate = estimate_track_noise(recording.tracks[static_cast<std::size_t>(m)]);
            if (!estimate.found || !(estimate.sigma_m > 0.0)) continue;
            sum(m) += estimate.sigma_m * estimate.sigma_m;
            found(m) += 1.0;
        }
    // A tenth of a millimetre, a usual camera's, when nothing is known at all.
    const double typical = found.sum() > 0.0 ? std::sqrt(sum.sum() / found.sum()) : 1e-4;
    if (found.sum() == 0.0) study.warnings.push_back("markers.noise_m: not declared and not to be estimated from the traces; 0.1 mm is assumed");
    study.noise_m.resize(count);
    for (Eigen::Index m = 0; m < count; ++m)
        study.noise_m(m) = std::max({found(m) > 0.0 ? std::sqrt(sum(m) / found(m)) : typical, 0.5 * typical, rounded_m});
}

/// Trials in which no marker was seen take no part; one to fit must be left.
Result<void> check_seen(Study& study) {
    bool any = false;
    for (const StudyTrial& trial : study.trials) {
        const auto& tracks = trial.measured.tracks;
        const bool seen = std::any_of(tracks.begin(), tracks.end(), [](const Eigen::Matrix3Xd& track) { return !track.array().isNaN().all(); });
        any = any || (seen && trial.role == TrialRole::fit);
        if (!seen) study.warnings.push_back("trial " + trial.name + ": no marker was seen in it, so it takes no part");
        else if (trial.measured.sample_count() < 3) study.warnings.push_back("trial " + trial.name + ": " + std::to_string(trial.measured.sample_count()) + " samples tell next to nothing");
    }
    if (!any) return declaration_error(study.experiment, "trial", "no marker was seen in any trial to fit");
    return {};
}

void warn_of_mass(const Model& model, std::vector<std::string>& warnings) {
    if (model.mass_model == MassModel::consistent) return;
    const double part = mass_matrix(model).nodal_kg.sum() / (model.density_kg_m3 * model.body->volume_m3);
    warnings.push_back("equal vertex masses: the body weighs " + format_number(100.0 * part, 3) + " % of its mesh's true mass");
}

/// @param model  without muscles, whose activations the trials bring
double assumed_damping_s(const Model& model, const StudySettings& settings) {
    if (settings.assumed_damping_s == 0.0) return 0.0;
    const double omega = first_vibration_rad_s(model);
    if (!(omega > 0.0)) return settings.assumed_damping_s;
    return std::min(settings.assumed_damping_s, 2.0 * settings.most_assumed_damping_ratio / omega);
}

/// What the trials' clocks and the range of activations leave to doubt.
void add_warnings(Study& study) {
    const auto add = [&](const std::vector<std::string>& sentences) {
        study.warnings.insert(study.warnings.end(), sentences.begin(), sentences.end());
    };
    add(doubtful_frames(study));
    add(activation_notes(study));
}

}  // namespace

StudySettings published_settings() {
    StudySettings settings;
    settings.mesh.element = ElementKind::hex8_full;
    settings.mesh.voxels = Voxels::truncated;
    settings.integrator = Integrator::implicit_euler;
    settings.material = "projective_corotational";
    settings.mass_model = MassModel::equal_vertices;
    settings.assumed_damping_s = 0.0;
    settings.as_published = true;
    return settings;
}

std::vector<Signal> with_level(const Experiment& experiment, std::vector<Signal> activation, std::size_t leader, double level) {
    const std::vector<MuscleLeader> leaders = muscle_leaders(experiment);
    for (std::size_t m = 0; m < leaders.size(); ++m)
        if (leaders[m].leader == leader) activation[m] = Signal::step(0.0, 1.0, 1.0 + leaders[m].factor * (level - 1.0));
    return activation;
}

void declare_activation(const Experiment& experiment, std::vector<Signal>& activation) {
    const std::vector<MuscleLeader> leaders = muscle_leaders(experiment);
    for (std::size_t m = 0; m < leaders.size(); ++m) {
        const std::optional<Signal>& signal = experiment.muscles[leaders[m].leader].signal;
        if (!signal) continue;
        activation[m] = *signal;
        for (double& a : activation[m].values) a = 1.0 + leaders[m].factor * (a - 1.0);
    }
}

std::vector<Signal> level_tangent(const Experiment& experiment, std::size_t leader) {
    std::vector<Signal> tangent;
    for (const MuscleLeader& muscle : muscle_leaders(experiment))
        tangent.push_back(Signal::step(0.0, 0.0, muscle.leader == leader ? muscle.factor : 0.0));
    return tangent;
}

double sampling_interval_s(const StudyTrial& trial) {
    return trial.measured.rate_Hz > 0.0 ? 1.0 / trial.measured.rate_Hz : 0.01;
}

void set_step(StudyTrial& trial, double h_s) {
    trial.options.h_s = h_s;
    trial.model.activation.clear();
    for (const Signal& signal : trial.recorded_activation)
        trial.model.activation.push_back(with_switches_as_jumps(signal, h_s));
}

double mean_noise(const Study& study) { return std::sqrt(study.noise_m.squaredNorm() / static_cast<double>(study.noise_m.size())); }

void check_integration(Study& study) {
    const auto shortest = std::min_element(study.trials.begin(), study.trials.end(),
                                           [](const StudyTrial& a, const StudyTrial& b) { return a.options.h_s < b.options.h_s; });
    study.integration = check_integration(shortest->model, shortest->options.integrator, shortest->options.h_s);
    const std::vector<std::string>& found = study.integration->warnings;
    study.warnings.insert(study.warnings.end(), found.begin(), found.end());
}

Study with_fine_element(Study study) {
    study.settings.fine_element = true;
    const ElementKind fine = fine_element(study.body->kind);
    if (fine == study.body->kind) return study;
    study.body = of_kind(*study.body, fine);
    for (StudyTrial& trial : study.trials) trial.model.body = study.body;
    return study;
}

Result<Study> prepare_study(const Experiment& experiment, const StudySettings& settings, const Progress& progress, const StudyMesh* meshed) {
    Study study;
    study.experiment = experiment;
    study.settings = settings;
    study.warnings = experiment.warnings;
    Result<SurfaceMesh> surface = read_body_surface(experiment);
    if (!surface) return surface.error();
    study.surface = std::move(*surface);
    if (const Result<void> fits = check_on_body(experiment, study.surface); !fits) return fits.error();

    if (!settings.as_published)
        if (const Result<void> positive = check_declared_activation(experiment); !positive) return positive.error();

    const std::string law = settings.material.value_or(experiment.material.model);
    const MaterialPointer material = find_material(law);
    if (!material) return declaration_error(experiment, "material.model", "no material law '" + law + "'");

    const Box held = held_part(experiment.clamp_box_m, bounding_box(study.surface.vertices));
    Result<StudyMesh> mesh = meshed ? *meshed : mesh_body(study.surface, settings.mesh, {held}, progress);
    if (!mesh) return mesh.error();
    study.mesh = std::move(*mesh);
    study.warnings.insert(study.warnings.end(), study.mesh.warnings.begin(), study.mesh.warnings.end());
    const std::vector<std::string> unfit = unsuitable({study.surface, study.mesh, experiment.effects});
    study.warnings.insert(study.warnings.end(), unfit.begin(), unfit.end());
    const std::vector<int> clamped = nodes_in_box(study.mesh.mesh, box_on_mesh(study.mesh, held));
    if (clamped.empty())
        return declaration_error(experiment, "clamp.box_m", "no node of the mesh lies in the box; choose a finer resolution or a deeper box");
    if (static_cast<Eigen::Index>(clamped.size()) == study.mesh.mesh.node_count()) return holds_whole_body(experiment);
    const bool fine = settings.fine_element || any_varies_within_cells(experiment.effects);
    study.body = make_body(study.mesh.mesh, fine ? fine_element(study.mesh.element) : study.mesh.element, clamped);

    std::vector<Eigen::Vector3d> rest;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        study.marker_names.push_back(marker.name);
        rest.push_back(marker.rest_m);
    }
    study.markers = marker_set(study.mesh.mesh, rest);

    Model model;
    model.body = study.body;
    model.material = material;
    model.moduli = uniform_moduli(study.body->cell_count(), experiment.material.youngs_modulus_Pa, experiment.material.poissons_ratio);
    model.density_kg_m3 = experiment.material.density_kg_m3;
    model.mass_model = settings.mass_model;
    warn_of_mass(model, study.warnings);
    model.velocity_force_1_s = settings.velocity_force_1_s;
    model.gravity_m_s2 = experiment.gravity_m_s2;
    model.damping_s =
        experiment.material.damping_s ? *experiment.material.damping_s : assumed_damping_s(model, settings);
    Result<std::vector<FibreGroup>> muscles = muscle_groups(experiment, study.mesh, &study.warnings);
    if (!muscles) return muscles.error();
    model.fibres = std::make_shared<const std::vector<FibreGroup>>(std::move(*muscles));

    std::vector<Recording> recordings;
    for (const TrialDeclaration& declaration : experiment.trials) {
        if (progress.cancelled()) return Error{"stopped before trial " + declaration.name + " was read", ""};
        Result<StudyTrial> trial = prepare_trial(study, model, declaration, study.warnings);
        if (!trial) return trial.error();
        recordings.push_back(trial->measured);
        study.trials.push_back(std::move(*trial));
    }
    if (const Result<void> seen = check_seen(study); !seen) return seen.error();
    for (const EffectDeclaration& effect : experiment.effects)
        if (experiment.muscles.empty() && find_effect(effect.id)->stage == EffectStage::actuation)
            study.warnings.push_back("effect " + effect.id + ": there is no muscle, so it does nothing");
    set_noise(recordings, study);
    add_warnings(study);
    return study;
}

}  // namespace myo
