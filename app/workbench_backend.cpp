#include "workbench_backend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "dynamics/numerical_damping.hpp"
#include "material/catalogue.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/rigid_motion.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/surface_topology.hpp"
#include "diagnosis_view.hpp"
#include "loop/whole_diagnosis.hpp"
#include "mesh_scene.hpp"
#include "project/calibrate_study.hpp"
#include "project/muscle_groups.hpp"
#include "project/read_experiment.hpp"
#include "project/readable_parameter.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using Eigen::Matrix3Xd;

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

bool is_experiment(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(path, code) || path.extension() == ".toml";
}

/// What a scene was opened from.
struct SceneSource {
    Experiment experiment;
    SurfaceMesh surface;
};

const SceneSource& source_of(const Scene& scene) { return *std::static_pointer_cast<const SceneSource>(scene.source); }

MeshRequest mesh_request(const Settings& settings) { return {default_element(settings.element), settings.resolution_m}; }

StudySettings study_settings(const Settings& settings) {
    StudySettings result;
    result.mesh = mesh_request(settings);
    parse_integrator(settings.integrator, result.integrator);
    result.spectral_radius = settings.spectral_radius;
    result.h_s = settings.time_step_s;
    result.material = settings.material;
    result.velocity_force_1_s = settings.velocity_force_1_s;
    result.threads = hardware_threads();
    return result;
}

/// The muscles of the settings; where they leave something open, as the experiment has it.
std::vector<MuscleDeclaration> declared_muscles(const Experiment& experiment, const Settings& settings) {
    std::vector<MuscleDeclaration> muscles;
    for (const Muscle& muscle : settings.muscles) {
        MuscleDeclaration declared{muscle.name, MuscleMask{std::make_shared<const PaintedMask>(), std::nullopt}, 0.0, std::nullopt, std::nullopt};
        for (const MuscleDeclaration& own : experiment.muscles)
            if (own.name == muscle.declared) declared = own;
        declared.stiffness_Pa = muscle.stiffness_Pa;
        if (muscle.paint) declared.part = MuscleMask{muscle.paint, std::nullopt};
        declared.follows.reset();
        declared.signal.reset();
        if (muscle.follows.empty()) declared.signal = muscle.signal;
        else declared.follows = FollowsDeclaration{muscle.follows, muscle.ratio};
        muscles.push_back(std::move(declared));
    }
    return muscles;
}

/// The experiment's own muscles, as they are shown before anything is changed.
std::vector<Muscle> shown_muscles(const Experiment& experiment) {
    std::vector<Muscle> muscles;
    for (const MuscleDeclaration& declared : experiment.muscles) {
        Muscle muscle;
        muscle.name = muscle.declared = declared.name;
        muscle.color = static_cast<int>(muscles.size());
        muscle.stiffness_Pa = declared.stiffness_Pa;
        muscle.signal = declared.signal;
        if (declared.follows) muscle.follows = declared.follows->muscle, muscle.ratio = declared.follows->ratio;
        muscles.push_back(std::move(muscle));
    }
    return muscles;
}

Experiment with_settings(Experiment experiment, const Settings& settings) {
    experiment.material.youngs_modulus_Pa = settings.youngs_modulus_Pa;
    experiment.material.poissons_ratio = settings.poissons_ratio;
    experiment.material.density_kg_m3 = settings.density_kg_m3;
    experiment.material.damping_s = settings.damping_s;
    for (const AddedEffect& effect : settings.effects) experiment.effects.push_back(declaration(effect));
    experiment.muscles = declared_muscles(experiment, settings);
    return experiment;
}

/// Where displacements are compared, both curves start from the declared rest position.
Matrix3Xd shown_measurement(const Study& study, const StudyTrial& trial, std::size_t marker) {
    Matrix3Xd shown = trial.measured.tracks[marker];
    if (!trial.reference_m.empty())
        shown.colwise() += Eigen::Vector3d(study.experiment.markers.on_body[marker].rest_m - trial.reference_m[marker]);
    return shown;
}

/// Frequency of the largest measured motion about where it comes to rest [Hz], from its zero crossings; 0 when it does not cross.
double dominant_frequency(const Study& study) {
    double largest = 0.0, frequency = 0.0;
    for (const StudyTrial& trial : study.trials)
        for (const Matrix3Xd& track : trial.measured.tracks)
            for (int axis = 0; axis < 3; ++axis) {
                const Eigen::Index samples = track.cols(), tail = std::max<Eigen::Index>(1, samples / 5);
                const double rest = track.row(axis).tail(tail).mean();
                double sum = 0.0, first = 0.0, last = 0.0;
                int crossings = 0;
                for (Eigen::Index t = trial.first_sample + 1; t < samples; ++t) {
                    const double a = track(axis, t - 1) - rest, b = track(axis, t) - rest;
                    if (!std::isfinite(a * b)) continue;
                    sum += b * b;
                    if (a * b >= 0.0) continue;
                    last = trial.measured.time_s(t - 1) + (trial.measured.time_s(t) - trial.measured.time_s(t - 1)) * a / (a - b);
                    if (crossings++ == 0) first = last;
                    if (crossings == 9) break;   // later ones may be noise
                }
                if (sum <= largest || crossings < 3) continue;
                largest = sum;
                frequency = (crossings - 1) / (2.0 * (last - first));
            }
    return frequency;
}

void fill_from_study(const Study& study, Scene& scene) {
    const Experiment& experiment = study.experiment;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) scene.markers.push_back({marker.name, marker.rest_m});
    for (const StudyTrial& trial : study.trials) {
        SceneTrial shown{trial.name, trial.role == TrialRole::fit ? "fit" : "validate", trial.measured.time_s, {}, {}};
        for (std::size_t m = 0; m < scene.markers.size(); ++m) shown.measured.push_back(shown_measurement(study, trial, m));
        for (std::size_t m = 0; m < experiment.muscles.size(); ++m) shown.activation[experiment.muscles[m].name] = trial.model.activation[m];
        scene.trials.push_back(std::move(shown));
    }
    scene.settings.element = study.mesh.mesh.type;
    scene.settings.resolution_m = study.mesh.resolution_m;
    scene.settings.material = experiment.material.model;
    scene.settings.youngs_modulus_Pa = experiment.material.youngs_modulus_Pa;
    scene.settings.poissons_ratio = experiment.material.poissons_ratio;
    scene.settings.density_kg_m3 = experiment.material.density_kg_m3;
    scene.settings.damping_s = study.trials.front().model.damping_s;
    scene.settings.integrator = to_string(study.settings.integrator);
    scene.settings.time_step_s = study.trials.front().options.h_s;
    scene.settings.muscles = shown_muscles(experiment);
    scene.frequency_Hz = dominant_frequency(study);
    for (const StudyParameter& parameter : study_parameters(study)) scene.calibrated.push_back(parameter.parameter.name);
}

/// Frames of a trace up to `end_s`, thinned so that a long run of a large body stays within some 200 MB. Runs go on past the data
/// as far as the start may be shifted; body and markers are shown together.
void add_frames(const Trace& trace, double end_s, SimulatedTrial& shown) {
    const double bytes = 24.0 * static_cast<double>(trace.positions.front().cols() * static_cast<Eigen::Index>(trace.positions.size()));
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(bytes / 2e8)));
    std::vector<double> times;
    for (std::size_t k = 0; k < trace.positions.size(); k += stride) {
        if (k > 0 && trace.times_s[k] > end_s * (1.0 + 1e-9)) break;
        times.push_back(trace.times_s[k]);
        shown.frames.push_back(trace.positions[k]);
    }
    shown.frame_time_s = Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
}

RunResult shown_run(const Study& study, const StudyRun& run) {
    RunResult result;
    result.seconds = run.seconds;
    result.problem = run.failure;
    if (study.integration) result.warnings = study.integration->warnings;
    std::vector<Matrix3Xd> all;
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        const TrialPrediction& prediction = run.predictions[t];
        SimulatedTrial shown;
        shown.name = study.trials[t].name;
        const Eigen::VectorXd& sampled = study.trials[t].measured.time_s;
        if (!prediction.trace.positions.empty())
            add_frames(prediction.trace, sampled.size() > 0 ? sampled(sampled.size() - 1) : prediction.trace.times_s.back(), shown);
        for (std::size_t m = 0; m < study.marker_names.size() && prediction.ok(); ++m) {
            // The prediction in the form in which it is compared: measurement plus residual, but without the gaps.
            Matrix3Xd track = small_rotation(run.values.rotation_rad) * prediction.positions_m[m];
            track.colwise() += run.values.translation_m;
            if (!study.trials[t].reference_m.empty())
                track.colwise() += Eigen::Vector3d(study.experiment.markers.on_body[m].rest_m - prediction.start_m[m]);
            shown.markers.push_back(std::move(track));
            shown.marker_rms_m.push_back(rms({prediction.residual_m[m]}));
        }
        shown.rms_m = rms(prediction.residual_m);
        all.insert(all.end(), prediction.residual_m.begin(), prediction.residual_m.end());
        result.trials.push_back(std::move(shown));
    }
    result.rms_m = rms(all);
    return result;
}

class CoreBackend final : public Backend {
public:
    std::vector<Choice> materials() const override {
        std::vector<Choice> list;
        const std::map<std::string, std::string> labels = {{"neo_hookean", "Neo-Hookean"},
                                                           {"corotational", "Corotational"},
                                                           {"projective_corotational", "Projective corotational (as published)"},
                                                           {"st_venant_kirchhoff", "St. Venant–Kirchhoff"}};
        for (const MaterialPointer& law : material_catalogue())
            list.push_back({law->id(), labels.count(law->id()) > 0 ? labels.at(law->id()) : law->id(), law->formula()});
        return list;
    }

    std::vector<Choice> integrators() const override {
        const auto entry = [](Integrator integrator, const char* label, const char* explanation) {
            const auto damping = [integrator](double omega, const Settings& s) {
                const TimeScheme scheme{integrator, s.spectral_radius};
                return omega > 0.0 ? std::max(0.0, discrete_vibration(scheme, {omega}, s.time_step_s).damping_ratio) : 0.0;   // rounding
            };
            const auto critical = [integrator](double omega, const Settings& s) {
                return critical_velocity_force({integrator, s.spectral_radius}, omega, s.time_step_s, 0.5 * s.damping_s * omega);
            };
            return Choice{to_string(integrator), label, explanation, damping, critical, integrator == Integrator::generalized_alpha};
        };
        return {entry(Integrator::tr_bdf2, "TR-BDF2", "Second order, no visible damping of its own: for data"),
                entry(Integrator::implicit_euler, "Implicit Euler", "First order, as in the paper: damps by itself"),
                entry(Integrator::bdf2, "BDF2", "Second order, one solve a step, damps more than TR-BDF2"),
                entry(Integrator::generalized_alpha, "Generalised-α", "Second order, one solve a step, damping by choice of ρ∞"),
                entry(Integrator::trapezoidal, "Trapezoidal", "Second order, no damping at all: large motions may become unstable")};
    }

    bool needs_unit(const fs::path& path) const override { return fs::is_regular_file(path) && !is_experiment(path); }

    Result<Signal> read_signal(const fs::path& path, const std::string& muscle) const override {
        const Result<ActuationTable> table = read_actuation_csv(path);
        if (!table) return table.error();
        auto column = std::find(table->muscles.begin(), table->muscles.end(), muscle);
        if (column == table->muscles.end() && table->muscles.size() == 1) column = table->muscles.begin();
        if (column == table->muscles.end()) return Error{"has no column \"" + muscle + "\", only " + join(table->muscles), path.string()};
        const Eigen::VectorXd row = table->values.row(column - table->muscles.begin());
        return Signal{{table->time_s.begin(), table->time_s.end()}, {row.begin(), row.end()}};
    }

    Result<void> write_signal(const fs::path& path, const std::string& muscle, const Signal& signal) const override {
        ActuationTable table;
        table.muscles = {muscle};
        const auto knots = static_cast<Eigen::Index>(signal.times_s.size());
        table.time_s = Eigen::Map<const Eigen::VectorXd>(signal.times_s.data(), knots);
        table.values = Eigen::Map<const Eigen::RowVectorXd>(signal.values.data(), knots);
        return write_actuation_csv(path, table);
    }

    Result<Scene> open(const fs::path& path, std::optional<double> metres_per_unit, const Progress& progress) override {
        return is_experiment(path) ? open_experiment(path, progress) : open_mesh(path, metres_per_unit);
    }

    MeshPrediction predict(const Scene& scene, const Settings& settings) const override {
        if (scene.surface.triangles.cols() == 0) return {};
        const CountEstimate estimate = estimate_counts(scene.surface, settings.element, settings.resolution_m);
        return {estimate.cells, estimate.dofs, estimate.exact};
    }

    Result<MeshedBody> mesh(const Scene& scene, const Settings& settings, const Progress& progress) override {
        const SceneSource& source = source_of(scene);
        Result<StudyMesh> made = mesh_body(source.surface, mesh_request(settings), {held_part(source.experiment.clamp_box_m, bounding_box(source.surface.vertices))}, progress);
        if (!made) return made.error();
        const QualityReport quality = mesh_quality(made->mesh, &source.surface);
        MeshedBody body;
        body.boundary = boundary_faces(made->mesh);
        body.dofs = static_cast<double>(quality.dofs);
        body.report = {{"Elements", std::to_string(quality.cells)},
                       {"Degrees of freedom", std::to_string(quality.dofs)},
                       {"Volume", formatted("%.4g cm³", 1e6 * quality.volume)},
                       {"Volume error", formatted("%.3f %%", 100.0 * quality.volume_error.value_or(0.0)), std::abs(quality.volume_error.value_or(0.0)) > 0.02},
                       {"Least " + quality.measure, formatted("%.3f", quality.least), quality.least < 0.1},
                       {"Mean edge", formatted("%.3g mm", 1e3 * quality.mean_edge)}};
        const Result<std::vector<FibreGroup>> groups = muscle_groups(source.experiment, *made);
        if (!groups) return groups.error();
        for (const FibreGroup& group : *groups) body.muscles[group.name] = paint_of_group(made->mesh, group);
        for (const std::string& message : quality.messages) body.report.push_back({"Note", message, true});
        body.mesh = std::move(made->mesh);
        return body;
    }

    Result<RunResult> simulate(const Scene& scene, const MeshedBody&, const Settings& settings, const Progress& progress) override {
        if (source_of(scene).experiment.trials.empty())
            return run_mesh_scene(with_settings(source_of(scene).experiment, settings), source_of(scene).surface, study_settings(settings), settings, progress);
        Result<Study> study = prepare_study(with_settings(source_of(scene).experiment, settings), study_settings(settings), progress);
        if (!study) return study.error();
        check_integration(*study);
        return shown_run(*study, run_study(*study, with_predicted_levels(*study, declared_values(*study)), progress));
    }

    Result<CalibrationResult> calibrate(const Scene& scene, const MeshedBody&, const Settings& settings, const Progress& progress) override {
        Result<Study> study = prepare_study(with_settings(source_of(scene).experiment, settings), study_settings(settings), progress);
        if (!study) return study.error();
        check_integration(*study);
        const Calibration calibration = calibrate_study(*study, {}, progress);
        if (!calibration.usable()) return Error{calibration.fit.message, ""};
        CalibrationResult result;
        result.settings = settings;
        result.evaluations = calibration.fit.evaluations;
        result.stopped = calibration.stopped;
        result.warnings = calibration.warnings;
        if (!calibration.fit.converged() && !calibration.stopped) result.problem = "The fit did not converge: " + calibration.fit.message;
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            const ReadableParameter shown = readable_parameter(calibration.parameters[i], *study);
            result.parameters.push_back({shown.name, shown.unit, shown.factor * calibration.fit.start(k), shown.factor * calibration.fit.values(k),
                                         shown.factor * calibration.fit.deviations(k)});
        }
        result.rms_before_m = calibration.before.fit_rms_m;
        result.rms_after_m = calibration.after.fit_rms_m;
        result.settings.youngs_modulus_Pa = calibration.after.values.youngs_modulus_Pa;
        result.settings.damping_s = calibration.after.values.damping_s;
        result.run = shown_run(*study, calibration.after);
        result.run.seconds = calibration.seconds;
        return result;
    }

    Result<DiagnosisView> diagnose(const Scene& scene, const MeshedBody&, const Settings& settings, const Progress& progress, const LiveDiagnosis& live) override {
        StudySettings chosen = study_settings(settings);
        // Steps that nobody changed are the diagnosis' to choose.
        if (settings.time_step_s == scene.settings.time_step_s) chosen.h_s.reset();
        const Result<Study> study = prepare_study(with_settings(source_of(scene).experiment, settings), chosen, progress);
        if (!study) return study.error();
        const DiagnosisSource source{*study, source_of(scene).experiment.effects.size(), settings};
        const auto show = [&](const Diagnosis& known) {
            if (live) live(std::make_shared<const DiagnosisView>(diagnosis_view(source, known)));
        };
        const Diagnosis d = whole_diagnosis(*study, {}, progress, show);
        if (!d.failure.empty()) return Error{d.failure, ""};
        if (!d.declared.usable()) return Error{"stopped before the declared fit", ""};
        progress.report({"forces of the effects", 0.0, 1.0, "stage", {}});
        DiagnosisView view = diagnosis_view(source, d);
        if (d.complete()) add_forces(source, d, view);
        return view;
    }

private:
    static Result<Scene> open_experiment(const fs::path& path, const Progress& progress) {
        const Result<Experiment> experiment = read_experiment(path);
        if (!experiment) return experiment.error();
        StudySettings settings;
        settings.threads = hardware_threads();
        const Result<Study> study = prepare_study(*experiment, settings, progress);
        if (!study) return study.error();
        Scene scene;
        scene.path = path;
        scene.name = experiment->name;
        scene.description = experiment->description;
        scene.surface = study->surface;
        scene.clamp_m = experiment->clamp_box_m;
        scene.warnings = study->warnings;
        fill_from_study(*study, scene);
        scene.source = std::make_shared<const SceneSource>(SceneSource{*experiment, study->surface});
        return scene;
    }

    static Result<Scene> open_mesh(const fs::path& path, std::optional<double> metres_per_unit) {
        if (!metres_per_unit) return Error{"the file does not say its unit; choose m or mm", path.string()};
        const Result<SurfaceMesh> read = read_surface(path, *metres_per_unit);
        if (!read) return read.error();
        const SurfaceMesh surface = weld(*read);
        const SurfaceReport report = check_surface(surface);
        if (const Result<void> size = check_plausible_size(report.size); !size) return Error{size.error().what, path.string()};
        if (!report.closed) return Error{"the surface is not closed: " + join(report.messages), path.string()};
        Scene scene;
        scene.path = path;
        scene.name = path.stem().string();
        scene.surface = report.outward ? surface : flipped(surface);
        scene.warnings = report.messages;
        const Experiment experiment = mesh_scene_experiment(scene.surface, scene.name);
        scene.description = experiment.description;
        scene.clamp_m = experiment.clamp_box_m;
        scene.trials.push_back(mesh_scene_trial());
        scene.settings = mesh_scene_settings(experiment, scene.surface);
        scene.source = std::make_shared<const SceneSource>(SceneSource{experiment, scene.surface});
        return scene;
    }
};

}  // namespace

std::shared_ptr<Backend> make_core_backend() { return std::make_shared<CoreBackend>(); }

}  // namespace myo
