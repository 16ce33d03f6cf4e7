#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/check_view.hpp"
#include "commands/diagnosis_view.hpp"
#include "commands/project.hpp"
#include "commands/recording_import.hpp"
#include "commands/run_result.hpp"
#include "commands/scene_marker.hpp"
#include "commands/search_result.hpp"
#include "commands/settings.hpp"
#include "fibre/cell_paint.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

// The seam between the workbench and the numerical core: plain values, and one abstract class that makes them.

namespace myo::ui::commands {

/// What a time step does to a vibration.
struct StepQuality {
    double frequency_error = 0.0;  // relative
    CheckState state = CheckState::green;
};

/// One entry of a list to choose from.
struct Choice {
    std::string id;
    std::string label;
    std::string explanation;  // shown on hovering; may hold the equation
    // For integrators only, of a vibration of an angular frequency [rad/s] under the settings. Empty = none worth
    // showing.
    std::function<double(double, const Settings&)> numerical_damping_ratio = {};  // that the scheme itself adds
    std::function<double(double, const Settings&)> critical_velocity_force =
        {};                            // [1/s] above which it grows; slow: keep the result
    bool has_spectral_radius = false;  // to choose
    std::function<StepQuality(double, const Settings&)> step_quality = {};  // of the settings' step
};

/// A quantity that has a value everywhere in the body.
struct FieldKind {
    std::string id;
    std::string label;
    std::string unit;            // shown
    double per_unit = 1.0;       // SI per shown unit
    bool signed_values = false;  // its zero is in the middle of the colours
    std::string explanation;
};

/// One line of a report: "Volume error", "0.02 %".
struct ReportLine {
    std::string label;
    std::string value;
    bool warning = false;
    std::string explanation = {};  // on hovering
};

/// What the cameras saw, in the mesh frame; t = 0 at release.
struct SceneTrial {
    std::string name;
    std::string role;                                      // "fit" or "validate"
    Eigen::VectorXd time_s;                                // T
    std::vector<Eigen::Matrix3Xd> measured;                // per marker of the scene, 3 x T [m], NaN = occluded
    std::map<std::string, fibre::Signal> activation = {};  // a(t) of the experiment's own muscles, by their names
};

/// Between its samples, on the mean [s]; 0 where it has fewer than two.
inline double sample_interval_s(const SceneTrial& trial) {
    const Eigen::Index last = trial.time_s.size() - 1;
    return last > 0 ? (trial.time_s[last] - trial.time_s[0]) / static_cast<double>(last) : 0.0;
}

/// What was opened: a body, how it is held, and its measurements. A plain mesh has no markers and no trials.
struct Scene {
    std::filesystem::path path;
    std::string name;
    std::string description;
    mesh::SurfaceMesh surface;  // may be empty
    std::optional<Box> clamp_m;
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();
    std::vector<SceneMarker> markers;
    std::vector<SceneTrial> trials;
    Settings settings;          // declared or default values
    double frequency_Hz = 0.0;  // of the dominant measured vibration; 0 = unknown
    double
        damping_ratio = std::numeric_limits<double>::quiet_NaN();  // of that vibration; NaN = it does not swing freely
    std::vector<std::string> calibrated;  // labels of what calibration moves; empty = it cannot be calibrated
    std::vector<std::string> warnings;
    CheckRows checks;                    // of the experiment as it is declared; none of a plain mesh
    std::shared_ptr<const void> source;  // the backend's own
};

/// Whether there is a fit trial with measured markers, which a diagnosis needs.
inline bool can_be_diagnosed(const Scene& scene) {
    for (const SceneTrial& trial : scene.trials)
        if (trial.role == "fit" && !trial.measured.empty()) return true;
    return false;
}

struct MeshPrediction {
    double elements = 0.0;
    double dofs = 0.0;
    bool exact = false;  // else an estimate
};

struct MeshedBody {
    mesh::VolumeMesh mesh;
    mesh::BoundaryFaces boundary;
    double dofs = 0.0;
    std::vector<ReportLine> report;
    std::map<std::string, fibre::CellPaint> muscles;  // where the experiment's own muscles are, by their names
    std::shared_ptr<const void> source;               // the backend's own
};

/// A part of a scene's motion.
struct RunExtent {
    std::size_t trial = 0;
    double end_s = 0.0;  // of that trial it is from 0 until here
};

/// An example that comes with the program.
struct Example {
    std::filesystem::path path;
    std::string name;
    std::string description;
};

/// A part of the program that others have made.
struct Library {
    std::string name;
    std::string version;
    std::string licence;
};

/// Does the work. Its functions are called from a background thread, one at a time, except those marked quick, which
/// the workbench calls while it draws, and which must return within a millisecond.
class Backend {
public:
    virtual ~Backend() = default;

    /// Quantities that can colour the body (quick).
    virtual const std::vector<FieldKind>& fields() const = 0;
    /// Its values at the nodes [SI] in one frame of a run of this body. May be called from any thread, beside
    /// everything else.
    virtual Eigen::VectorXd field(const std::string& id, const MeshedBody& body, const RunResult& run,
                                  std::size_t trial, std::size_t frame) const = 0;

    virtual std::vector<Choice> materials() const = 0;    // quick
    virtual std::vector<Choice> integrators() const = 0;  // quick

    virtual std::vector<Example> examples() const = 0;   // quick
    virtual std::string version() const = 0;             // quick, of the program
    virtual std::vector<Library> libraries() const = 0;  // quick

    /// What is known of a file before it is opened: "Name", "Trials", ...; empty when nothing (quick).
    virtual std::vector<ReportLine> preview(const std::filesystem::path& path) const = 0;

    virtual Result<Project> read_project(const std::filesystem::path& file) const = 0;
    /// Masks of painted muscles go into files beside it, in `<name>.files`.
    virtual Result<void> write_project(const std::filesystem::path& file, const Project& project) const = 0;

    /// Whether the numbers in this file have a unit that only a person knows (quick).
    virtual bool needs_unit(const std::filesystem::path& path) const = 0;

    /// @param path             an experiment folder, its experiment.toml, or a mesh file
    /// @param metres_per_unit  of a mesh file without unit; else ignored
    virtual Result<Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                               const Progress& progress) = 0;

    /// How large the mesh will be (quick).
    virtual MeshPrediction predict(const Scene& scene, const Settings& settings) const = 0;

    virtual Result<MeshedBody> mesh(const Scene& scene, const Settings& settings, const Progress& progress) = 0;

    /// All trials of the scene, in its order.
    /// @param only  part to be run, moving as in the whole run; empty: all. Other trials have no frames and no markers
    /// then, markers after its end are NaN. May be called from any thread, beside everything else.
    virtual Result<RunResult> simulate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                       const std::optional<RunExtent>& only, const Progress& progress) = 0;

    /// `live` gets what a search knows after its evaluations, from the calling thread; may be empty.
    using LiveSearch = std::function<void(std::shared_ptr<const SearchView>)>;
    /// Cancelled, it gives the best values so far; an error when there are none yet.
    virtual Result<SearchResult> calibrate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                           const Progress& progress, const LiveSearch& live) = 0;
    /// Signals of the muscles with which the markers of a trial follow their traces. Cancelled likewise.
    virtual Result<SearchResult> optimize(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                          const OptimizeRequest& request, const Progress& progress,
                                          const LiveSearch& live) = 0;

    /// The column of a muscle in a file of signals, `time_s,<muscle>,...`; a file of one column may have any name
    /// (quick).
    virtual Result<fibre::Signal> read_signal(const std::filesystem::path& path, const std::string& muscle) const = 0;
    /// Writes the same form (quick).
    virtual Result<void> write_signal(const std::filesystem::path& path, const std::string& muscle,
                                      const fibre::Signal& signal) const = 0;

    /// Writes simulated markers, and the pages of a search and a diagnosis where there are some (null: none), into a
    /// folder; the files' names. Short.
    virtual Result<std::vector<std::string>> write_report(const std::filesystem::path& folder, const Scene& scene,
                                                          const RunResult& run, const SearchResult* found,
                                                          const DiagnosisView* diagnosis) const = 0;

    /// A file of motion capture.
    virtual Result<RecordingFile> read_recording(const std::filesystem::path& path,
                                                 const ReadingOptions& options) const = 0;
    /// Markers that the experiment declares, those on the mount included; none for a plain mesh (quick).
    virtual std::vector<SceneMarker> declared_markers(const Scene& scene) const = 0;
    /// Where the choices put the recording (quick).
    virtual ImportView view_import(const Scene& scene, const RecordingFile& file,
                                   const ImportChoices& choices) const = 0;
    /// Which label may be which marker: by their names and distances where markers are declared; else those without a
    /// place get the nearest one of the body (quick, some milliseconds).
    virtual Result<ImportChoices> propose_markers(const Scene& scene, const MeshedBody& body, const RecordingFile& file,
                                                  const ImportChoices& choices) const = 0;
    /// The start with which the recording follows the run of a trial best [s, the file's time] (quick, some
    /// milliseconds).
    virtual Result<double> align_import(const Scene& scene, const SimulatedTrial& run, const Eigen::VectorXd& time_s,
                                        const RecordingFile& file, const ImportChoices& choices) const = 0;
    /// Makes a trial of it; the experiment that has it now.
    virtual Result<std::filesystem::path> add_recording(const Scene& scene, const Settings& settings,
                                                        const RecordingFile& file,
                                                        const ImportChoices& choices) const = 0;

    /// What the model lacks. `live` gets what is known so far after every stage, from the calling thread; may be empty.
    /// Cancelled, it gives that, too.
    using LiveDiagnosis = std::function<void(std::shared_ptr<const DiagnosisView>)>;
    virtual Result<DiagnosisView> diagnose(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                           const Progress& progress, const LiveDiagnosis& live) = 0;
};

}  // namespace myo::ui::commands
