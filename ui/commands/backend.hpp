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
#include "commands/body_actuators.hpp"
#include "commands/check_view.hpp"
#include "commands/declared_parts.hpp"
#include "commands/diagnosis_view.hpp"
#include "commands/goal_view.hpp"
#include "commands/live_model.hpp"
#include "commands/project.hpp"
#include "commands/recording_import.hpp"
#include "commands/run_result.hpp"
#include "commands/scene_marker.hpp"
#include "commands/scene_setup.hpp"
#include "commands/scene_support.hpp"
#include "commands/scene_unknown.hpp"
#include "commands/search_result.hpp"
#include "commands/seek_choice.hpp"
#include "commands/settings.hpp"
#include "commands/shape_export.hpp"
#include "commands/trace_repairs.hpp"
#include "fibre/cell_paint.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

// Interface between the workbench and the numerical core: plain values, and one abstract class that creates them. The
// library `ui` contains no physics; the application implements Backend with the core, tests with a closed form.

namespace myo::ui::commands {

/// Effect of a time step on a vibration.
struct StepQuality {
    double frequency_error = 0.0;          // relative, without unit
    CheckState state = CheckState::green;  // green: the error can be neglected
};

/// A number that a chosen entry has, e.g. a parameter of a material law; Settings::law holds its value.
struct ChoiceNumber {
    std::string key;               // in settings and project files
    std::string label, unit, tip;  // shown; the unit may be empty
    double usual = 0.0;            // where the settings hold none
    Limits limits{0.0, 0.0};       // for edits
};

/// One entry of a list to choose from, such as a material or a time scheme.
struct Choice {
    std::string id;           // in settings and project files
    std::string label;        // shown
    std::string explanation;  // tooltip; may contain the equation
    // The following is set for time schemes only. Each function takes the angular frequency of a vibration [rad/s] and
    // the settings. An empty function means that the scheme has nothing worth showing.
    std::function<double(double, const Settings&)> numerical_damping_ratio = {};  // damping ratio that the scheme adds
    std::function<double(double, const Settings&)> critical_velocity_force =
        {};                            // [1/s] above which the motion grows; slow: keep the result
    bool has_spectral_radius = false;  // the user can choose it
    std::function<StepQuality(double, const Settings&)> step_quality = {};  // for the time step in the settings
    std::vector<ChoiceNumber> numbers = {};                                 // set for material laws only
};

/// A scalar quantity that is defined everywhere in the body and can colour it.
struct FieldKind {
    std::string id;              // in project files
    std::string label;           // shown
    std::string unit;            // shown
    double per_unit = 1.0;       // SI per shown unit
    bool signed_values = false;  // values have a sign: zero gets the middle colour
    std::string explanation;     // tooltip
};

/// One line of a report: "Volume error", "0.02 %".
struct ReportLine {
    std::string label;
    std::string value;
    bool warning = false;          // the value should be noticed
    std::string explanation = {};  // tooltip
};

/// Command of a chamber or tendon over time.
struct ShownCommand {
    fibre::Signal signal;   // SI
    std::string unit;       // shown
    double per_unit = 1.0;  // SI per shown unit
};

/// Load of a trial, as declared.
struct SceneLoad {
    bool is_mass = false;                                      // otherwise a force
    Box box_m;                                                 // part of the surface that carries it
    double mass_kg = 0.0;                                      // of a mass
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();         // of a force
    double from_s = -std::numeric_limits<double>::infinity();  // times in which a force acts
    double until_s = std::numeric_limits<double>::infinity();
    std::optional<fibre::Signal> curve = {};  // factor of a force over time; excludes the two

    /// Factor of the force at t [s].
    double factor(double t) const { return curve ? curve->value(t) : t >= from_s && t <= until_s ? 1.0 : 0.0; }
};

/// One trial of an experiment: measured markers in the mesh frame over time. t = 0 is the release.
struct SceneTrial {
    std::string name;
    std::string role;                                      // "fit", "validate" or "simulate"
    Eigen::VectorXd time_s;                                // T sample times [s], ascending
    std::vector<Eigen::Matrix3Xd> measured;                // per marker of the scene, 3 x T [m]; NaN = occluded
    std::map<std::string, fibre::Signal> activation = {};  // declared signals a(t) by muscle name
    std::map<std::string, ShownCommand> commands = {};     // of chambers and tendons, by name
    std::vector<SceneLoad> loads = {};                     // in the order of declaration
    double duration_s = 0.0;                               // of a trial without a recording, else 0
    std::vector<SceneGoal> goals = {};                     // in the order of declaration; Optimise follows them
    TraceRepairs repairs = {};
};

/// Whether a marker was seen in a trial. Trials that are only simulated, and probes, have nothing measured.
inline bool is_seen(const SceneTrial& trial, std::size_t marker) {
    return marker < trial.measured.size() && !trial.measured[marker].array().isNaN().all();
}

/// Mean interval between the samples of a trial [s]. Returns 0 if there are fewer than two.
inline double sample_interval_s(const SceneTrial& trial) {
    const Eigen::Index last = trial.time_s.size() - 1;
    return last > 0 ? (trial.time_s[last] - trial.time_s[0]) / static_cast<double>(last) : 0.0;
}

/// What was opened: a body, its support and its measurements. A plain mesh has no markers and no trials.
///
/// Created by the backend and shared read-only between the UI thread and the jobs.
struct Scene {
    std::filesystem::path path;  // the opened folder or file
    std::string name;
    std::string description;
    mesh::SurfaceMesh surface;                               // surface of the body [m]; may be empty
    std::optional<Box> clamp_m;                              // box that holds the body; empty: none
    SceneSupports supports;                                  // in addition to the clamp
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();  // world frame
    std::vector<SceneMarker> markers;                        // of the experiment
    std::vector<SceneTrial> trials;
    Settings settings;          // declared values, defaults for the rest
    double frequency_Hz = 0.0;  // of the dominant measured vibration; 0 = unknown
    // Damping ratio of that vibration; NaN if it does not swing freely.
    double damping_ratio = std::numeric_limits<double>::quiet_NaN();
    // labels of the parameters that calibration changes; empty: nothing to calibrate
    std::vector<std::string> calibrated;
    std::vector<SeekChoice> seekable;   // what Optimise can seek in addition to the signals
    bool is_experiment = false;         // with a declaration that can be edited; otherwise a plain mesh
    DeclaredParts declared;             // of an experiment: chambers, tendons, cavities
    std::vector<std::string> unknowns;  // material.calibrate: "youngs_modulus", "damping", ...
    SceneUnknowns fitted;               // what a fit finds, with bounds
    SceneEffects effects;
    std::vector<SceneObstacle> obstacles;
    std::vector<ScenePart> parts;
    std::map<int, int> regions;          // numbers that a volume mesh has for its cells: how many have each
    std::vector<std::string> warnings;   // from reading the files
    CheckRows checks;                    // of the experiment as declared; empty for a plain mesh
    std::shared_ptr<const void> source;  // owned by the backend, opaque to the workbench
};

/// Whether the scene has a trial of role fit with measured markers, which a diagnosis requires.
inline bool can_be_diagnosed(const Scene& scene) {
    for (const SceneTrial& trial : scene.trials)
        if (trial.role == "fit" && !trial.measured.empty()) return true;
    return false;
}

/// Size of a mesh before it is built.
struct MeshPrediction {
    double elements = 0.0;  // number of cells
    double dofs = 0.0;      // degrees of freedom
    bool exact = false;     // counted, otherwise estimated
};

/// A meshed body. Shared read-only by jobs and the view.
struct MeshedBody {
    mesh::VolumeMesh mesh;                            // nodes in the rest frame [m]
    mesh::BoundaryFaces boundary;                     // faces on the boundary, for drawing
    double dofs = 0.0;                                // degrees of freedom
    std::vector<ReportLine> report;                   // quality of the mesh, as shown
    std::map<std::string, fibre::CellPaint> muscles;  // declared muscles on this mesh, by name
    BodyActuators actuators;                          // declared chambers and tendons on this mesh
    std::shared_ptr<const void> source;               // owned by the backend, opaque to the workbench
};

/// The first part of one trial, for a preview.
struct RunExtent {
    std::size_t trial = 0;  // index in Scene::trials
    double end_s = 0.0;     // from 0 to this time of the trial [s]
};

/// Picture of a body for the start page: shaded triangles, projected into the plane of the picture.
struct ExamplePicture {
    struct Triangle {
        std::array<float, 6> corners;  // x, y of each; the longer side of the picture is 1 long, y points down
        float light = 1.0f;            // 0 to 1
    };
    std::vector<Triangle> triangles;  // far ones first; empty: no picture
    float width = 0.0f, height = 0.0f;
};

/// An experiment that comes with the program.
struct Example {
    std::filesystem::path path;
    std::string name;
    std::string description;
    ExamplePicture picture = {};  // of its body
};

/// A third-party library or font in the program, for the dialog with its licences.
struct Library {
    std::string name;
    std::string version;
    std::string licence;
};

/// Does the numerical work for the workbench.
///
/// Functions marked quick are called on the UI thread while a frame is drawn; they must return within a millisecond.
/// All others are called from a background thread, one at a time unless stated otherwise. A long function reports its
/// progress and checks `progress.cancelled()`.
class Backend {
public:
    virtual ~Backend() = default;

    /// Quantities that can colour the body. Quick.
    virtual const std::vector<FieldKind>& fields() const = 0;
    /// Values of a field at the nodes [SI unit of the field] in one frame of a run of this body.
    ///
    /// Called from any thread, concurrently with everything else. The number of values is the number of nodes.
    virtual Eigen::VectorXd field(const std::string& id, const MeshedBody& body, const RunResult& run,
                                  std::size_t trial, std::size_t frame) const = 0;

    virtual std::vector<Choice> materials() const = 0;    // quick; material laws to choose from
    virtual std::vector<Choice> integrators() const = 0;  // quick; time schemes to choose from

    virtual std::vector<Example> examples() const = 0;   // quick
    virtual std::string version() const = 0;             // quick; of the program
    virtual std::vector<Library> libraries() const = 0;  // quick

    /// Facts about a file or folder that is not open, for the file browser: "Name", "Trials", … Empty if nothing is
    /// known. Quick.
    virtual std::vector<ReportLine> preview(const std::filesystem::path& path) const = 0;

    /// Reads a project file. Values that the project names but that are missing are reported in Project::warnings, a
    /// missing experiment or mesh in Project::source_missing.
    virtual Result<Project> read_project(const std::filesystem::path& file) const = 0;
    /// Writes a project file. Masks of painted muscles go into separate files in the folder `<name>.files`, and so does
    /// a copy of the experiment or mesh if the project is self-contained.
    virtual Result<void> write_project(const std::filesystem::path& file, const Project& project) const = 0;

    /// Claims a project's file for this window, until the returned value is destroyed. Null where files need no claim.
    /// Errors: another window has it open, with its process; or the claim cannot be written.
    virtual Result<std::shared_ptr<const void>> claim_project(const std::filesystem::path&) const {
        return std::shared_ptr<const void>();
    }
    /// Name and time of unsaved work, for the question whether to recover it: "finger, 29 Nov 2026, 14:05". Quick.
    virtual std::string recovery_words(const std::filesystem::path& file) const { return file.stem().string(); }

    /// Whether a file contains lengths without a unit, so that the user has to be asked. Quick.
    virtual bool needs_unit(const std::filesystem::path& path) const = 0;

    /// Reads an experiment or a mesh.
    ///
    /// @param path  an experiment folder, its experiment.toml, or a mesh file
    /// @param metres_per_unit  length unit of a mesh file without unit; ignored otherwise
    virtual Result<Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                               const Progress& progress) = 0;

    /// Applies edits to the declaration of an experiment. Whether the result is an experiment, redeclared() says.
    /// Quick.
    virtual Result<Declaration> edited(const Scene& scene, const Declaration& declaration,
                                       const std::vector<DeclarationEdit>& edits) const = 0;
    /// The scene with another declaration; its settings stay. Reads the recordings of the trials. Called on the UI
    /// thread: a mesh is made only if neither the shown one nor that of the scene serves.
    ///
    /// @param body  shown body, null: none
    virtual Result<Scene> redeclared(const Scene& scene, const Declaration& declaration,
                                     const MeshedBody* body) const = 0;
    /// Declared chambers and tendons on a mesh of the scene's body; empty if the mesh lost one. Called on the UI
    /// thread.
    virtual BodyActuators actuators(const Scene&, const MeshedBody& body) const { return body.actuators; }
    /// Shares of the materials in each cell of a mesh of the scene's body by volume: column 0 is the body's own, column
    /// 1 + k that of part k. Empty without parts, or if they do not fit the mesh. Called on the UI thread.
    virtual Eigen::MatrixXd part_shares(const Scene&, const MeshedBody&) const { return {}; }
    /// Writes an edited declaration to the experiment's file, and masks that it names beside it.
    virtual Result<void> write_declaration(const Scene& scene, const Declaration& declaration) const = 0;
    /// Writes a plain mesh with the settings as an experiment with one trial that is simulated.
    virtual Result<void> write_plain_experiment(const std::filesystem::path& folder, const Scene& scene,
                                                const Settings& settings) const = 0;

    /// Copies the experiment's folder to a new one, with the edited declaration and with the files from elsewhere that
    /// it names. The opened experiment stays as it is.
    virtual Result<void> write_experiment_copy(const std::filesystem::path& folder, const Scene& scene,
                                               const Declaration& declaration) const = 0;
    /// Writes the body in one frame; the extension of the file decides the format: .vtu, .stl or .glb. Called from any
    /// thread.
    virtual Result<void> write_shape(const std::filesystem::path& file, const MeshedBody& body,
                                     const ShapeFrame& frame) const = 0;
    /// Writes a collection (.pvd) of the files of frames at these times [s].
    virtual Result<void> write_shape_series(const std::filesystem::path& file, const std::vector<double>& times_s,
                                            const std::vector<std::filesystem::path>& files) const = 0;

    /// Estimates the size of the mesh that these settings would give. Quick.
    virtual MeshPrediction predict(const Scene& scene, const Settings& settings) const = 0;

    /// Builds the mesh of the scene's body with the element type and edge length of the settings.
    virtual Result<MeshedBody> mesh(const Scene& scene, const Settings& settings, const Progress& progress) = 0;

    /// Simulates all trials of the scene, in the scene's order. Called from any thread, concurrently with everything
    /// else.
    ///
    /// @param only  part to simulate, with the same motion as in the whole run; empty: everything. Other trials then
    ///              have no frames and no markers, and markers after the end of the part are NaN.
    virtual Result<RunResult> simulate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                       const std::optional<RunExtent>& only, const Progress& progress) = 0;

    /// Makes a model that plays live, from the start of a trial or, if `before` is a model of the same mesh, from where
    /// that one is. Called on the thread that will move it.
    ///
    /// @param trial  index in Scene::trials
    /// @param before  null: none
    virtual Result<std::unique_ptr<LiveModel>> live(const Scene& scene, const MeshedBody& body,
                                                    const Settings& settings, std::size_t trial,
                                                    const LiveModel* before, const Progress& progress) = 0;

    /// Receives intermediate results of a search after its evaluations, on the search's thread. May be empty.
    using LiveSearch = std::function<void(std::shared_ptr<const SearchView>)>;
    /// Fits the unknown parameters to the trials of role fit. If cancelled, returns the best values so far, or an error
    /// if there are none.
    virtual Result<SearchResult> calibrate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                           const Progress& progress, const LiveSearch& live) = 0;
    /// Finds muscle signals with which the markers of a trial reach its goals, or else follow their measured paths.
    /// Cancelling works as in calibrate().
    virtual Result<SearchResult> optimize(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                          const OptimizeRequest& request, const Progress& progress,
                                          const LiveSearch& live) = 0;

    /// Reads the signal of a muscle from a CSV file `time_s,<muscle>,...`. In a file with one signal the column may
    /// have any name. Quick.
    virtual Result<fibre::Signal> read_signal(const std::filesystem::path& path, const std::string& muscle) const = 0;
    /// Writes a signal in the same format. Quick.
    virtual Result<void> write_signal(const std::filesystem::path& path, const std::string& muscle,
                                      const fibre::Signal& signal) const = 0;

    /// Writes a report into a folder: simulated markers as tables, and the pages of a search and a diagnosis if they
    /// are given (may be null). Called on the UI thread, as it is short.
    ///
    /// @return names of the files
    virtual Result<std::vector<std::string>> write_report(const std::filesystem::path& folder, const Scene& scene,
                                                          const RunResult& run, const SearchResult* found,
                                                          const DiagnosisView* diagnosis) const = 0;

    /// Reads a motion capture file.
    virtual Result<RecordingFile> read_recording(const std::filesystem::path& path,
                                                 const ReadingOptions& options) const = 0;
    /// Markers declared by the experiment, including those on the mount; empty for a plain mesh. Quick.
    virtual std::vector<SceneMarker> declared_markers(const Scene& scene) const = 0;
    /// Evaluates the user's import choices: placement of the recording, residuals, and what is missing. Quick.
    virtual ImportView view_import(const Scene& scene, const RecordingFile& file,
                                   const ImportChoices& choices) const = 0;
    /// Proposes which label is which marker: by names and distances if the experiment declares markers. On a plain
    /// mesh, labels without a position get the nearest point of the body. Takes some milliseconds; called on the UI
    /// thread.
    virtual Result<ImportChoices> propose_markers(const Scene& scene, const MeshedBody& body, const RecordingFile& file,
                                                  const ImportChoices& choices) const = 0;
    /// Finds the start time [s, in the file's time] with which the recording follows the simulated trial best. Takes
    /// some milliseconds; called on the UI thread.
    ///
    /// @param time_s  sample times of the run's markers
    virtual Result<double> align_import(const Scene& scene, const SimulatedTrial& run, const Eigen::VectorXd& time_s,
                                        const RecordingFile& file, const ImportChoices& choices) const = 0;
    /// Adds the recording as a trial to the experiment, or to a new one. Returns the path of the experiment.
    virtual Result<std::filesystem::path> add_recording(const Scene& scene, const Settings& settings,
                                                        const RecordingFile& file,
                                                        const ImportChoices& choices) const = 0;

    /// Receives the intermediate result after each part of a diagnosis, on the diagnosis' thread. May be empty.
    using LiveDiagnosis = std::function<void(std::shared_ptr<const DiagnosisView>)>;
    /// Finds out what the model lacks. If cancelled, returns what is known so far, without a verdict.
    virtual Result<DiagnosisView> diagnose(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                           const Progress& progress, const LiveDiagnosis& live) = 0;
};

}  // namespace myo::ui::commands
