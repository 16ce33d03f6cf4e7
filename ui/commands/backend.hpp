#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/diagnosis_view.hpp"
#include "commands/settings.hpp"
#include "fibre/cell_paint.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

// The seam between the workbench and the numerical core: plain values, and one abstract class that makes them.

namespace myo {

/// One entry of a list to choose from.
struct Choice {
    std::string id;
    std::string label;
    std::string explanation;        // shown on hovering; may hold the equation
    // For integrators only, of a vibration of an angular frequency [rad/s] under the settings. Empty = none worth showing.
    std::function<double(double, const Settings&)> numerical_damping_ratio = {};   // that the scheme itself adds
    std::function<double(double, const Settings&)> critical_velocity_force = {};   // [1/s] above which it grows; slow: keep the result
    bool has_spectral_radius = false;                                              // to choose
};

/// One line of a report: "Volume error", "0.02 %".
struct ReportLine {
    std::string label;
    std::string value;
    bool warning = false;
};

struct SceneMarker {
    std::string name;
    Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();
};

/// What the cameras saw, in the mesh frame; t = 0 at release.
struct SceneTrial {
    std::string name;
    std::string role;                             // "fit" or "validate"
    Eigen::VectorXd time_s;                       // T
    std::vector<Eigen::Matrix3Xd> measured;       // per marker of the scene, 3 x T [m], NaN = occluded
    std::map<std::string, Signal> activation = {};   // a(t) of the experiment's own muscles, by their names
};

/// What was opened: a body, how it is held, and its measurements. A plain mesh has no markers and no trials.
struct Scene {
    std::filesystem::path path;
    std::string name;
    std::string description;
    SurfaceMesh surface;                          // may be empty
    std::optional<Box> clamp_m;
    std::vector<SceneMarker> markers;
    std::vector<SceneTrial> trials;
    Settings settings;                            // declared or default values
    double frequency_Hz = 0.0;                    // of the dominant measured vibration; 0 = unknown
    std::vector<std::string> calibrated;          // labels of what calibration moves; empty = it cannot be calibrated
    std::string cannot_run;                       // why it cannot be simulated; empty = it can
    std::vector<std::string> warnings;
    std::shared_ptr<const void> source;           // the backend's own
};

/// Whether there is a fit trial with measured markers, which a diagnosis needs.
inline bool can_be_diagnosed(const Scene& scene) {
    if (!scene.cannot_run.empty()) return false;
    for (const SceneTrial& trial : scene.trials)
        if (trial.role == "fit" && !trial.measured.empty()) return true;
    return false;
}

struct MeshPrediction {
    double elements = 0.0;
    double dofs = 0.0;
    bool exact = false;                           // else an estimate
};

struct MeshedBody {
    VolumeMesh mesh;
    BoundaryFaces boundary;
    double dofs = 0.0;
    std::vector<ReportLine> report;
    std::map<std::string, CellPaint> muscles;     // where the experiment's own muscles are, by their names
    std::shared_ptr<const void> source;           // the backend's own
};

/// One simulated trial; frames may be coarser than the measurement.
struct SimulatedTrial {
    std::string name;                             // of the SceneTrial
    Eigen::VectorXd frame_time_s;                 // F
    std::vector<Eigen::Matrix3Xd> frames;         // F node positions, 3 x n [m]
    std::vector<Eigen::Matrix3Xd> markers;        // per marker of the scene, 3 x T at the trial's time_s [m]
    std::vector<double> marker_rms_m;             // per marker, NaN without measurement
    double rms_m = 0.0;                           // NaN without measurement
};

struct RunResult {
    std::vector<SimulatedTrial> trials;
    double rms_m = 0.0;                           // over all measured coordinates of all trials; NaN without any
    double seconds = 0.0;                         // wall time
    std::string problem;                          // what went wrong on the way; empty = nothing
    std::vector<std::string> warnings;            // of its time step
};

/// A calibrated parameter in the unit it is shown in.
struct ParameterRow {
    std::string name;                             // "Young's modulus E"
    std::string unit;                             // "kPa"
    double start = 0.0;
    double value = 0.0;
    double deviation = 0.0;                       // one standard deviation; NaN = unknown
};

struct CalibrationResult {
    std::vector<ParameterRow> parameters;
    double rms_before_m = 0.0;
    double rms_after_m = 0.0;
    int evaluations = 0;
    Settings settings;                            // with the calibrated values
    RunResult run;                                // with the calibrated values
    bool stopped = false;                         // by the user: these are the best values up to then
    std::string problem;
    std::vector<std::string> warnings;            // what a person should know before trusting the values
};

/// Does the work. Its functions are called from a background thread, one at a time, except those marked quick, which the
/// workbench calls while it draws, and which must return within a millisecond.
class Backend {
public:
    virtual ~Backend() = default;

    virtual std::vector<Choice> materials() const = 0;      // quick
    virtual std::vector<Choice> integrators() const = 0;    // quick

    /// Whether the numbers in this file have a unit that only a person knows (quick).
    virtual bool needs_unit(const std::filesystem::path& path) const = 0;

    /// @param path             an experiment folder, its experiment.toml, or a mesh file
    /// @param metres_per_unit  of a mesh file without unit; else ignored
    virtual Result<Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit, const Progress& progress) = 0;

    /// How large the mesh will be (quick).
    virtual MeshPrediction predict(const Scene& scene, const Settings& settings) const = 0;

    virtual Result<MeshedBody> mesh(const Scene& scene, const Settings& settings, const Progress& progress) = 0;

    /// All trials of the scene, in its order.
    virtual Result<RunResult> simulate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                       const Progress& progress) = 0;

    /// Cancelled, it gives the best values so far; an error when there are none yet.
    virtual Result<CalibrationResult> calibrate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                                const Progress& progress) = 0;

    /// The column of a muscle in a file of signals, `time_s,<muscle>,...`; a file of one column may have any name (quick).
    virtual Result<Signal> read_signal(const std::filesystem::path& path, const std::string& muscle) const = 0;
    /// Writes the same form (quick).
    virtual Result<void> write_signal(const std::filesystem::path& path, const std::string& muscle, const Signal& signal) const = 0;

    /// What the model lacks. `live` gets what is known so far after every stage, from the calling thread; may be empty. Cancelled, it
    /// gives that, too.
    using LiveDiagnosis = std::function<void(std::shared_ptr<const DiagnosisView>)>;
    virtual Result<DiagnosisView> diagnose(const Scene& scene, const MeshedBody& body, const Settings& settings, const Progress& progress,
                                           const LiveDiagnosis& live) = 0;
};

}  // namespace myo
