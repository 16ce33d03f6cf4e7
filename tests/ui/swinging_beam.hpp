#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <set>

#include "commands/backend.hpp"

namespace myo::test {

/// Backend with a beam whose tip sinks and swings by a closed form: deflection ~ 1 / E, frequency ~ sqrt(E). It
/// replaces the core, so that tests drive the workbench within milliseconds.
class SwingingBeam : public ui::commands::Backend {
public:
    static constexpr double measured_modulus = 2.5e5;  // of the "measured" beam [Pa]

    /// Delay of each step of a run [s].
    std::atomic<double> step_delay_s = 0.0;

    std::vector<ui::commands::Choice> materials() const override;
    /// Fields: height above the rest position in mm, signed; and x, which never changes.
    const std::vector<ui::commands::FieldKind>& fields() const override;
    Eigen::VectorXd field(const std::string& id, const ui::commands::MeshedBody& body,
                          const ui::commands::RunResult& run, std::size_t trial, std::size_t frame) const override;
    /// Delay of each frame of a field [s].
    std::atomic<double> field_delay_s = 0.0;
    std::vector<ui::commands::Choice> integrators() const override;
    bool needs_unit(const std::filesystem::path& path) const override { return path.extension() == ".stl"; }
    Result<fibre::Signal> read_signal(const std::filesystem::path& path, const std::string& muscle) const override;
    Result<void> write_signal(const std::filesystem::path& path, const std::string& muscle,
                              const fibre::Signal& signal) const override;
    Result<ui::commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                     const Progress& progress) override;
    /// The beam has no file: its declaration is the text of its gravity, "9.81", which edits replace.
    Result<ui::commands::Declaration> edited(const ui::commands::Scene& scene,
                                             const ui::commands::Declaration& declaration,
                                             const std::vector<ui::commands::DeclarationEdit>& edits) const override;
    Result<ui::commands::Scene> redeclared(const ui::commands::Scene& scene,
                                           const ui::commands::Declaration& declaration,
                                           const ui::commands::MeshedBody* body) const override;
    Result<void> write_declaration(const ui::commands::Scene&, const ui::commands::Declaration&) const override {
        return {};
    }
    /// While set, the beam opens as an experiment whose declaration can be edited.
    bool as_experiment = false;
    /// While set, another declaration is refused.
    bool refuses_declarations = false;
    /// While set, the free end of a meshed beam is the wall of a chamber.
    bool has_chamber = false;
    /// Edits in the order in which they were asked for.
    mutable std::vector<ui::commands::DeclarationEdit> edits;
    Result<void> write_experiment_copy(const std::filesystem::path& folder, const ui::commands::Scene&,
                                       const ui::commands::Declaration&) const override {
        copies.push_back(folder);
        return {};
    }
    mutable std::vector<std::filesystem::path> copies;
    Result<void> write_shape(const std::filesystem::path& file, const ui::commands::MeshedBody&,
                             const ui::commands::ShapeFrame& frame) const override {
        shapes.emplace_back(file, frame);
        return {};
    }
    Result<void> write_shape_series(const std::filesystem::path& file, const std::vector<double>& times_s,
                                    const std::vector<std::filesystem::path>& files) const override {
        series.push_back({file, times_s, files});
        return {};
    }
    /// Written frames, and collections of them.
    mutable std::vector<std::pair<std::filesystem::path, ui::commands::ShapeFrame>> shapes;
    struct ShapeSeries {
        std::filesystem::path file;
        std::vector<double> times_s;
        std::vector<std::filesystem::path> files;
    };
    mutable std::vector<ShapeSeries> series;
    Result<void> write_plain_experiment(const std::filesystem::path& folder, const ui::commands::Scene&,
                                        const ui::commands::Settings&) const override {
        return Error{"not part of this test", folder.string()};
    }
    ui::commands::MeshPrediction predict(const ui::commands::Scene& scene,
                                         const ui::commands::Settings& settings) const override;
    Result<ui::commands::MeshedBody> mesh(const ui::commands::Scene& scene, const ui::commands::Settings& settings,
                                          const Progress& progress) override;
    Result<ui::commands::RunResult> simulate(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                             const ui::commands::Settings& settings,
                                             const std::optional<ui::commands::RunExtent>& only,
                                             const Progress& progress) override;
    /// A beam that swings by the same closed form; its one actuator, "lift", raises it by its level in m. A pull moves
    /// the held point towards the mouse at once.
    Result<std::unique_ptr<ui::commands::LiveModel>> live(const ui::commands::Scene& scene,
                                                          const ui::commands::MeshedBody& body,
                                                          const ui::commands::Settings& settings, std::size_t trial,
                                                          const ui::commands::LiveModel* before,
                                                          const Progress& progress) override;
    std::atomic<bool> refuses_live = false;         // no further model can be made
    std::atomic<int> live_models = 0;               // made so far
    std::atomic<double> live_velocity_force = 0.0;  // that the last step was told
    Result<ui::commands::SearchResult> calibrate(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                 const ui::commands::Settings& settings, const Progress& progress,
                                                 const LiveSearch& live) override;
    /// Tries some levels of the first muscle; the last one is the best.
    Result<ui::commands::SearchResult> optimize(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                const ui::commands::Settings& settings,
                                                const ui::commands::OptimizeRequest& request, const Progress& progress,
                                                const LiveSearch& live) override;
    std::vector<ui::commands::Example> examples() const override {
        return {{"/beam", "Swinging beam", "A beam that swings."}};
    }
    std::string version() const override { return "0"; }
    std::vector<ui::commands::Library> libraries() const override { return {{"Eigen", "3.4", "MPL 2"}}; }
    std::vector<ui::commands::ReportLine> preview(const std::filesystem::path& path) const override {
        return {{"Path", path.string()}};
    }
    /// Projects that another window has open.
    std::map<std::filesystem::path, std::string> open_elsewhere;
    Result<std::shared_ptr<const void>> claim_project(const std::filesystem::path& file) const override {
        const auto other = open_elsewhere.find(file);
        if (other != open_elsewhere.end()) return Error{other->second, ""};
        claimed.insert(file);
        return std::shared_ptr<const void>(this, [this, file](const void*) { claimed.erase(file); });
    }
    /// Projects that the window has claimed and not released.
    mutable std::set<std::filesystem::path> claimed;
    /// Projects are kept in memory; the file itself is empty.
    Result<ui::commands::Project> read_project(const std::filesystem::path& file) const override;
    Result<void> write_project(const std::filesystem::path& file, const ui::commands::Project& project) const override;
    Result<std::vector<std::string>> write_report(const std::filesystem::path& folder, const ui::commands::Scene& scene,
                                                  const ui::commands::RunResult& run,
                                                  const ui::commands::SearchResult* found,
                                                  const ui::commands::DiagnosisView* diagnosis) const override;
    /// Returns a fixed diagnosis of the kind that the core computes: linear drag explains most of the residual in z.
    Result<ui::commands::DiagnosisView> diagnose(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                                 const ui::commands::Settings& settings, const Progress& progress,
                                                 const LiveDiagnosis& live) override;

    /// A recording of the beam's declared markers under other names, shifted by 0.5 m, beginning 0.3 s before the
    /// release. Trials that are added to an experiment are kept in `added`.
    Result<ui::commands::RecordingFile> read_recording(const std::filesystem::path& path,
                                                       const ui::commands::ReadingOptions& options) const override;
    std::vector<ui::commands::SceneMarker> declared_markers(const ui::commands::Scene& scene) const override {
        return scene.markers;
    }
    ui::commands::ImportView view_import(const ui::commands::Scene& scene, const ui::commands::RecordingFile& file,
                                         const ui::commands::ImportChoices& choices) const override;
    Result<ui::commands::ImportChoices> propose_markers(const ui::commands::Scene& scene,
                                                        const ui::commands::MeshedBody& body,
                                                        const ui::commands::RecordingFile& file,
                                                        const ui::commands::ImportChoices& choices) const override;
    Result<double> align_import(const ui::commands::Scene&, const ui::commands::SimulatedTrial&, const Eigen::VectorXd&,
                                const ui::commands::RecordingFile&, const ui::commands::ImportChoices&) const override {
        return 0.31;
    }
    Result<std::filesystem::path> add_recording(const ui::commands::Scene& scene,
                                                const ui::commands::Settings& settings,
                                                const ui::commands::RecordingFile& file,
                                                const ui::commands::ImportChoices& choices) const override;
    mutable std::vector<ui::commands::ImportChoices> added;

    /// While set, a calibration stops after its first evaluation until it is cancelled or the flag is cleared.
    std::atomic<bool> hold_search = false;
    /// While set, a diagnosis stops after its first ranking until it is cancelled or the flag is cleared.
    std::atomic<bool> hold_diagnosis = false;
    /// Signal files by path.
    mutable std::map<std::filesystem::path, fibre::Signal> signals;
    mutable std::map<std::filesystem::path, ui::commands::Project> projects;
    /// Delay of writing a project [s].
    std::atomic<double> write_delay_s = 0.0;
    mutable std::vector<std::filesystem::path> reports;
    /// The diagnosis finds no effect that explains the residual, but a missing force.
    std::atomic<bool> unexplained = false;
    bool fewer_foretold = false;  // predict() returns half the elements
    /// State of the check of the start: when an experiment is opened, and after each job.
    std::atomic<ui::commands::CheckState> start_opened = ui::commands::CheckState::green,
                                          start_after = ui::commands::CheckState::green;
    /// Time step that runs choose if the user has set none [s]; 0: they do not choose.
    std::atomic<double> chosen_step_s = 0.0;
};

/// Position of a point of the beam at time t [s] for its position at rest [m].
Eigen::Vector3d beam_point(const Eigen::Vector3d& rest, double youngs_modulus_Pa, double t);

}  // namespace myo::test
