#include "backend/workbench_backend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "backend/body_actuators.hpp"
#include "backend/check_rows.hpp"
#include "backend/core_scene.hpp"
#include "backend/core_search.hpp"
#include "backend/declaration.hpp"
#include "backend/diagnosis_view.hpp"
#include "backend/examples.hpp"
#include "backend/fields.hpp"
#include "backend/file_preview.hpp"
#include "backend/law_settings.hpp"
#include "backend/library_versions.hpp"
#include "backend/live_model.hpp"
#include "backend/mesh_scene.hpp"
#include "backend/project_file.hpp"
#include "backend/recording_import.hpp"
#include "backend/scene_report.hpp"
#include "backend/scene_setup.hpp"
#include "backend/shape_files.hpp"
#include "backend/short_run.hpp"
#include "backend/shown_run.hpp"
#include "backend/user_files.hpp"
#include "base/folder_lock.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "check/step_level.hpp"
#include "diagnosis/report/diagnosis_report.hpp"
#include "diagnosis/whole_diagnosis.hpp"
#include "dynamics/material_damping.hpp"
#include "dynamics/numerical_damping.hpp"
#include "measurement/actuation_csv.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/vtk_writer.hpp"
#include "prediction/time_step.hpp"
#include "prediction/untested_fit.hpp"
#include "results/output_files.hpp"
#include "setup/muscle_groups.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// In percent; what rounds to zero has no sign.
std::string volume_error_text(double error) {
    const double thousandths = std::round(1e5 * error);
    return formatted("%.3f %%", thousandths == 0.0 ? 0.0 : 1e-3 * thousandths);
}

/// Backend of the window on the core; each method delegates to a file of this folder.
class CoreBackend final : public ui::commands::Backend {
public:
    std::vector<ui::commands::Choice> materials() const override { return law_choices(); }

    std::vector<ui::commands::Choice> integrators() const override {
        const auto entry = [](dynamics::Integrator integrator, const char* label, const char* explanation) {
            // Numerical damping ratio of a vibration with the settings of the window.
            const auto damping = [integrator](double omega, const ui::commands::Settings& s) {
                const dynamics::TimeScheme scheme{integrator, s.spectral_radius};
                return omega > 0.0
                           ? std::max(0.0, dynamics::discrete_vibration(scheme, {omega}, s.time_step_s).damping_ratio)
                           : 0.0;  // rounding
            };
            const auto critical = [integrator](double omega, const ui::commands::Settings& s) {
                return dynamics::critical_velocity_force(
                    {integrator, s.spectral_radius}, omega, s.time_step_s,
                    dynamics::damping_ratio(dynamics::slender_damping_factor(s.poissons_ratio), s.damping_s, omega));
            };
            const auto quality = [integrator](double omega, const ui::commands::Settings& s) {
                const dynamics::TimeScheme scheme{integrator, s.spectral_radius};
                const double error = std::abs(
                    dynamics::discrete_vibration(scheme, {omega}, s.time_step_s).frequency_error);
                return ui::commands::StepQuality{error, shown_state(check::step_level(error))};
            };
            const bool has_radius = integrator == dynamics::Integrator::generalized_alpha;
            return ui::commands::Choice{
                to_string(integrator), label, explanation, damping, critical, has_radius, quality};
        };
        return {entry(dynamics::Integrator::tr_bdf2, "TR-BDF2",
                      "Second order, no visible numerical damping: for data.\n"
                      "The trapezoidal rule over γ h, γ = 2 − √2, then BDF2 over the whole step (Bank et al. 1985)."),
                entry(dynamics::Integrator::implicit_euler, "Implicit Euler",
                      "First order, as in the paper: numerical damping ζ ≈ ω h / 2.\nx₁ = x₀ + h v₁, M (v₁ − v₀) / h = "
                      "f(x₁) + Λ M v₀"),
                entry(dynamics::Integrator::bdf2, "BDF2",
                      "Second order, one solve a step, damps more than TR-BDF2.\n"
                      "dy/dt = (3 y₁ − 4 y₀ + y₋₁) / (2 h) at the end of the step, y = x and M v (Hairer, Nørsett & "
                      "Wanner 1993, ch. III.5)."),
                entry(dynamics::Integrator::generalized_alpha, "Generalised-α",
                      "Second order, one solve a step, damping by choice of ρ∞.\n"
                      "α_m y'₁ + (1 − α_m) y'₀ = α_f f₁ + (1 − α_f) f₀, α_m = (3 − ρ∞) / (2 (1 + ρ∞)), α_f = 1 / (1 + "
                      "ρ∞) (Jansen, Whiting & Hulbert 2000)."),
                entry(dynamics::Integrator::trapezoidal, "Trapezoidal",
                      "Second order, no damping at all: large motions may become unstable.\n"
                      "(y₁ − y₀) / h = (y'₀ + y'₁) / 2, Newmark's method with β = 1/4, γ = 1/2 (Newmark 1959).")};
    }

    std::vector<ui::commands::Example> examples() const override { return bundled_examples(); }
    std::string version() const override { return MYOLOOP_VERSION; }
    std::vector<ui::commands::Library> libraries() const override {
        std::vector<ui::commands::Library> list;
        for (const LibraryVersion& library : library_versions)
            list.push_back({library.name, library.version, library.licence});
        return list;
    }
    std::vector<ui::commands::ReportLine> preview(const fs::path& path) const override { return preview_of(path); }
    Result<ui::commands::Project> read_project(const fs::path& file) const override { return read_project_file(file); }
    Result<void> write_project(const fs::path& file, const ui::commands::Project& project) const override {
        return write_project_file(file, project);
    }

    Result<std::shared_ptr<const void>> claim_project(const fs::path& file) const override {
        Result<FolderLock> lock = FolderLock::take_file(file);
        if (!lock) return lock.error();
        return std::shared_ptr<const void>(std::make_shared<FolderLock>(std::move(*lock)));
    }
    std::string recovery_words(const fs::path& file) const override { return unsaved_work_words(file); }

    bool needs_unit(const fs::path& path) const override {
        // Opening the file says why it cannot be read.
        std::error_code ignored;
        return fs::is_regular_file(path, ignored) && is_mesh_file(path);
    }

    Result<fibre::Signal> read_signal(const fs::path& path, const std::string& muscle) const override {
        const Result<measurement::ActuationTable> table = measurement::read_actuation_csv(path);
        if (!table) return table.error();
        auto column = std::find(table->muscles.begin(), table->muscles.end(), muscle);
        if (column == table->muscles.end() && table->muscles.size() == 1) column = table->muscles.begin();
        if (column == table->muscles.end())
            return Error{"has no column \"" + muscle + "\", only " + join(table->muscles), path.string()};
        const Eigen::VectorXd row = table->values.row(column - table->muscles.begin());
        return fibre::Signal{{table->time_s.begin(), table->time_s.end()}, {row.begin(), row.end()}};
    }

    Result<void> write_signal(const fs::path& path, const std::string& muscle,
                              const fibre::Signal& signal) const override {
        measurement::ActuationTable table;
        table.muscles = {muscle};
        const auto knots = static_cast<Eigen::Index>(signal.times_s.size());
        table.time_s = Eigen::Map<const Eigen::VectorXd>(signal.times_s.data(), knots);
        table.values = Eigen::Map<const Eigen::RowVectorXd>(signal.values.data(), knots);
        return measurement::write_actuation_csv(path, table);
    }

    Result<ui::commands::Scene> open(const fs::path& path, std::optional<double> metres_per_unit,
                                     const Progress& progress) override {
        return is_experiment(path) ? open_experiment(path, progress) : open_mesh(path, metres_per_unit);
    }

    Result<ui::commands::Declaration> edited(const ui::commands::Scene& scene,
                                             const ui::commands::Declaration& declaration,
                                             const std::vector<ui::commands::DeclarationEdit>& edits) const override {
        return edited_declaration(scene, declaration, edits);
    }
    Result<ui::commands::Scene> redeclared(const ui::commands::Scene& scene,
                                           const ui::commands::Declaration& declaration,
                                           const ui::commands::MeshedBody* body) const override {
        return redeclared_scene(scene, declaration, body);
    }
    ui::commands::BodyActuators actuators(const ui::commands::Scene& scene,
                                          const ui::commands::MeshedBody& body) const override {
        const SceneSource& source = source_of(scene);
        const auto* const mesh = static_cast<const setup::BodyMesh*>(body.source.get());
        Result<ui::commands::BodyActuators> found = body_actuators(source.experiment, source.surface, *mesh,
                                                                   body.boundary);
        return found ? std::move(*found) : ui::commands::BodyActuators{};
    }
    Eigen::MatrixXd part_shares(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body) const override {
        return shown_part_shares(source_of(scene).experiment, *static_cast<const setup::BodyMesh*>(body.source.get()));
    }
    Result<void> write_declaration(const ui::commands::Scene& scene,
                                   const ui::commands::Declaration& declaration) const override {
        return write_scene_declaration(scene, declaration);
    }
    Result<void> write_plain_experiment(const fs::path& folder, const ui::commands::Scene& scene,
                                        const ui::commands::Settings& settings) const override {
        return write_plain_scene(folder, scene, settings);
    }
    Result<void> write_experiment_copy(const fs::path& folder, const ui::commands::Scene& scene,
                                       const ui::commands::Declaration& declaration) const override {
        return write_scene_copy(folder, scene, declaration);
    }
    Result<void> write_shape(const fs::path& file, const ui::commands::MeshedBody& body,
                             const ui::commands::ShapeFrame& frame) const override {
        return write_shape_file(file, body, frame);
    }
    Result<void> write_shape_series(const fs::path& file, const std::vector<double>& times_s,
                                    const std::vector<fs::path>& files) const override {
        return mesh::write_pvd(file, times_s, files);
    }

    ui::commands::MeshPrediction predict(const ui::commands::Scene& scene,
                                         const ui::commands::Settings& settings) const override {
        if (scene.surface.triangles.cols() == 0) return {};
        if (const auto& opened = source_of(scene).mesh; opened && is_mesh_of(*opened, settings))
            return {static_cast<double>(opened->mesh.cell_count()),
                    3.0 * static_cast<double>(opened->mesh.node_count()), true};
        const mesh::CountEstimate estimate = mesh::estimate_counts(scene.surface, settings.element,
                                                                   settings.resolution_m);
        return {estimate.cells, estimate.dofs, estimate.exact};
    }

    Result<ui::commands::MeshedBody> mesh(const ui::commands::Scene& scene, const ui::commands::Settings& settings,
                                          const Progress& progress) override {
        const SceneSource& source = source_of(scene);
        // The mesh of the opened experiment or file is reused while the settings request the same.
        std::shared_ptr<const setup::BodyMesh> made = source.mesh;
        if (!made || !is_mesh_of(*made, settings)) {
            Result<setup::BodyMesh> fresh = setup::mesh_of(source.experiment, source.surface, mesh_request(settings),
                                                           progress);
            if (!fresh) return fresh.error();
            made = std::make_shared<const setup::BodyMesh>(std::move(*fresh));
        }
        const Error stopped{"meshing was stopped", ""};
        if (progress.cancelled()) return stopped;
        const mesh::QualityReport quality = mesh::mesh_quality(made->mesh, &source.surface);
        if (progress.cancelled()) return stopped;
        ui::commands::MeshedBody body;
        body.boundary = mesh::boundary_faces(made->mesh);
        body.dofs = static_cast<double>(quality.dofs);
        const std::string shape = made->mesh.type == mesh::CellType::hex8
                                      ? "the least det(e₁, e₂, e₃) / (|e₁| |e₂| |e₃|) of the edges at its corners and "
                                        "in its middle (Knupp 2003)"
                                      : "12 (3 V)^(2/3) / Σ of its squared edges (Liu & Joe 1994)";
        body.report = {
            {"Volume", formatted("%.4g cm³", 1e6 * quality.volume), false, "Sum over all elements."},
            {"Volume error", volume_error_text(quality.volume_error.value_or(0.0)),
             std::abs(quality.volume_error.value_or(0.0)) > 0.02,
             "(V − V₀) / V₀ of the elements' volume V and the surface's V₀; orange above 2 %."},
            {"Least " + quality.measure, formatted("%.3f", quality.least), quality.least < 0.1,
             "Shape of the worst element, " + shape + ": 1 is perfect, 0 flat, below 0 inverted; orange below 0.1."},
            {"Mean edge", formatted("%.3g mm", 1e3 * quality.mean_edge), false,
             "Mean length of the edges between corners, each once."}};
        if (is_volume_file(scene.path))
            body.report.insert(
                body.report.begin(),
                {"Made from", made == source.mesh ? "the file's own elements" : "the file's surface", false,
                 "A volume mesh keeps its own elements as long as their type and edge length are left as they were "
                 "opened."});
        // Paint of the declared muscles on this mesh, as a starting point for the brush.
        const Result<std::vector<fibre::FibreGroup>> groups = setup::muscle_groups(source.experiment, *made);
        if (!groups) return groups.error();
        for (const fibre::FibreGroup& group : *groups)
            body.muscles[group.name] = fibre::paint_of_group(made->mesh, group);
        Result<ui::commands::BodyActuators> actuators = body_actuators(source.experiment, source.surface, *made,
                                                                       body.boundary);
        if (!actuators) return actuators.error();
        body.actuators = std::move(*actuators);
        for (const std::string& message : quality.messages) body.report.push_back({"Note", message, true});
        body.mesh = made->mesh;
        body.source = std::move(made);
        return body;
    }

    const std::vector<ui::commands::FieldKind>& fields() const override { return field_catalogue(); }

    Eigen::VectorXd field(const std::string& id, const ui::commands::MeshedBody& body,
                          const ui::commands::RunResult& run, std::size_t trial, std::size_t frame) const override {
        return field_values(id, body, run, trial, frame);
    }

    Result<ui::commands::RunResult> simulate(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                             const ui::commands::Settings& settings,
                                             const std::optional<ui::commands::RunExtent>& only,
                                             const Progress& progress) override {
        if (source_of(scene).experiment.trials.empty()) return run_mesh_scene(scene, body, settings, only, progress);
        Result<setup::Setup> setup = scene_setup(scene, body, settings, setup_settings(settings), progress);
        if (!setup) return setup.error();
        const prediction::ParameterValues values = prediction::with_predicted_levels(
            *setup, prediction::declared_values(*setup));
        if (only) return shown_run(*setup, short_run(*setup, values, only->trial, only->end_s, progress));
        setup::check_integration(*setup);
        // A step that the user did not set may be shortened if the motion requires it.
        if (!settings.own_step) setup->settings.h_s.reset();
        const prediction::SetupRun run = prediction::run_with_chosen_steps(*setup, values, progress);
        ui::commands::RunResult shown = shown_run(*setup, run);
        if (!settings.own_step) shown.time_step_s = prediction::shortest_step_s(*setup);
        // Checks on an incomplete run would be misleading.
        if (progress.cancelled()) return shown;
        const std::vector<setup::TrialStep> seen = prediction::steps_seen_in(*setup, run);
        add_vibrations(seen, shown);
        const bool as_declared = true;
        shown.checks = check_rows(
            check::check_after({.setup = *setup, .run = &run, .as_declared = as_declared, .seen = &seen}), as_declared);
        return shown;
    }

    Result<std::unique_ptr<ui::commands::LiveModel>> live(const ui::commands::Scene& scene,
                                                          const ui::commands::MeshedBody& body,
                                                          const ui::commands::Settings& settings, std::size_t trial,
                                                          const ui::commands::LiveModel* before,
                                                          const Progress& progress) override {
        return make_live_model(scene, body, settings, trial, before, progress);
    }

    Result<ui::commands::SearchResult> calibrate(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                 const ui::commands::Settings& settings, const Progress& progress,
                                                 const LiveSearch& live) override {
        return calibrate_scene(scene, body, settings, progress, live);
    }

    Result<ui::commands::SearchResult> optimize(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                const ui::commands::Settings& settings,
                                                const ui::commands::OptimizeRequest& request, const Progress& progress,
                                                const LiveSearch& live) override {
        return optimize_scene(scene, body, settings, request, progress, live);
    }

    Result<std::vector<std::string>> write_report(const fs::path& folder, const ui::commands::Scene& scene,
                                                  const ui::commands::RunResult& run,
                                                  const ui::commands::SearchResult* found,
                                                  const ui::commands::DiagnosisView* diagnosis) const override {
        return write_scene_report(folder, scene, run, found, diagnosis);
    }

    Result<ui::commands::RecordingFile> read_recording(const fs::path& path,
                                                       const ui::commands::ReadingOptions& options) const override {
        return read_recording_file(path, options);
    }
    std::vector<ui::commands::SceneMarker> declared_markers(const ui::commands::Scene& scene) const override {
        return declared_scene_markers(scene);
    }
    ui::commands::ImportView view_import(const ui::commands::Scene& scene, const ui::commands::RecordingFile& file,
                                         const ui::commands::ImportChoices& choices) const override {
        return view_recording(scene, file, choices);
    }
    Result<ui::commands::ImportChoices> propose_markers(const ui::commands::Scene& scene,
                                                        const ui::commands::MeshedBody& body,
                                                        const ui::commands::RecordingFile& file,
                                                        const ui::commands::ImportChoices& choices) const override {
        return propose_recording_markers(scene, body, file, choices);
    }
    Result<double> align_import(const ui::commands::Scene& scene, const ui::commands::SimulatedTrial& run,
                                const Eigen::VectorXd& time_s, const ui::commands::RecordingFile& file,
                                const ui::commands::ImportChoices& choices) const override {
        return align_recording(scene, run, time_s, file, choices);
    }
    Result<fs::path> add_recording(const ui::commands::Scene& scene, const ui::commands::Settings& settings,
                                   const ui::commands::RecordingFile& file,
                                   const ui::commands::ImportChoices& choices) const override {
        return add_recording_trial(scene, settings, file, choices);
    }

    Result<ui::commands::DiagnosisView> diagnose(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                 const ui::commands::Settings& settings, const Progress& progress,
                                                 const LiveDiagnosis& live) override {
        setup::SetupSettings chosen = setup_settings(settings);
        // A step that the user did not set is chosen by the diagnosis.
        if (!settings.own_step) chosen.h_s.reset();
        Result<setup::Setup> setup = scene_setup(scene, body, settings, chosen, progress);
        if (!setup) return setup.error();
        if (const auto untested = prediction::untested_fit(*setup)) setup->warnings.push_back(*untested);
        const std::vector<check::Finding> on_units = check::findings_on_units(*setup);
        if (const Result<void> in_seconds = check::require_time_unit(*setup, on_units); !in_seconds)
            return in_seconds.error();
        if (!chosen.h_s) check::choose_declared_steps(*setup, on_units, progress);
        const std::vector<effect::EffectDeclaration> declared = ui::commands::effects_on(
            source_of(scene).experiment.effects, settings.off);
        const DiagnosisSource source{*setup, declared.size(), settings};
        const auto show = [&](const diagnosis::Diagnosis& known) {
            if (live) live(std::make_shared<const ui::commands::DiagnosisView>(diagnosis_view(source, known)));
        };
        const diagnosis::Diagnosis d = diagnosis::whole_diagnosis(*setup, {}, progress, show);
        if (!d.failure.empty()) return Error{d.failure, ""};
        if (!d.declared.usable()) return Error{"stopped before the declared fit", ""};
        progress.report({"forces of the effects", 0.0, 1.0, "phase", {}});
        ui::commands::DiagnosisView view = diagnosis_view(source, d);
        results::RunFacts facts{MYOLOOP_VERSION, {"workbench"}};
        if (d.complete()) {
            add_forces(source, d, view);
            facts.findings = check::check_after({diagnosis::as_diagnosed(d, *setup), &d.after});
            view.checks = check_rows(facts.findings);
            view.page = std::make_shared<const report::HtmlReport>(diagnosis::diagnosis_report(*setup, d, facts));
        }
        return view;
    }
};

}  // namespace

std::shared_ptr<ui::commands::Backend> make_core_backend() { return std::make_shared<CoreBackend>(); }

}  // namespace myo::backend
