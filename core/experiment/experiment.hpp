#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "effect/effect.hpp"
#include "experiment/goal.hpp"
#include "experiment/robot_parts.hpp"
#include "experiment/unknown.hpp"
#include "fibre/painted_mask.hpp"
#include "fibre/polyline.hpp"
#include "fibre/signal.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/trace_file.hpp"
#include "measurement/trace_repair.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

// The declarations of an experiment folder, value for value (schema experiment/1). SI units, mesh frame.

/// Rectangular block with edges along the axes of the mesh frame.
struct BoxGeometry {
    Eigen::Vector3d size_m;                              // edge lengths [m], the longest 1 mm to 10 m
    Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  // lowest corner [m]
};

/// Closed triangle surface, kind = "stl": an STL, OBJ, PLY or VTP file; vertices are scaled first, then rotated.
struct StlGeometry {
    std::filesystem::path file;    // absolute, or relative to the folder of the experiment
    double metres_per_unit = 1.0;  // length of the file's unit [m], see measurement::length_units
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // file axes to mesh frame, orthogonal
};

/// Volume mesh whose cells are used as they are, kind = "volume"; nodes are scaled first, then rotated.
struct VolumeGeometry {
    std::filesystem::path file;    // VTU, VTK, Gmsh MSH, TetGen node/ele; resolved
    double metres_per_unit = 1.0;  // length of the file's unit [m], see measurement::length_units
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // file axes to mesh frame, orthogonal
};

/// Shape of the body.
using Geometry = std::variant<BoxGeometry, StlGeometry, VolumeGeometry>;

/// Homogeneous material of the whole body and which of its parameters may be fitted.
struct MaterialDeclaration {
    std::string model;                      // id in the material catalogue
    std::vector<double> law = {};           // one value for each parameter of the law
    double youngs_modulus_Pa = 0.0;         // > 0; initial value of the fit
    double youngs_modulus_tolerance = 0.3;  // relative half-width
    double poissons_ratio = 0.0;            // strictly between 0 and 0.5
    double density_kg_m3 = 0.0;             // > 0
    std::optional<double> damping_s;        // Kelvin-Voigt damping time [s]; absent = unknown
    /// Parameters to fit: of youngs_modulus, damping, actuation_level and the law's own.
    std::vector<std::string> calibrate = {"youngs_modulus", "damping"};
};

/// Linear coupling of two muscles: a - 1 of the follower is `ratio` times a - 1 of the leader.
struct FollowsDeclaration {
    std::string muscle;  // name of the leader
    double ratio = 0.0;  // any sign; negative for antagonists
};

/// Muscle that fills the part of the body inside a box, with one fibre direction.
struct MuscleBox {
    Box box_m;              // mesh frame [m]
    Eigen::Vector3d fibre;  // unit vector
};

/// Muscle given element by element: weights and fibre directions painted on the body.
struct MuscleMask {
    std::variant<std::filesystem::path, std::shared_ptr<const fibre::PaintedMask>>
        painted;                           // a file, resolved, or what it would hold; never null
    std::optional<Eigen::Vector3d> fibre;  // unit; instead of the painted directions
};

/// Muscle of all material within a radius of a polyline; the fibres run along the line.
struct MuscleLine {
    fibre::Polyline line;   // points 3 x n [m], n >= 2, mesh frame
    double radius_m = 0.0;  // > 0
};

/// A muscle: where its fibres are, how stiff they are, and what actuates them.
struct MuscleDeclaration {
    std::string name;                                      // heads the column of the actuation file
    std::variant<MuscleBox, MuscleMask, MuscleLine> part;  // exactly one of box_m, mask, line_m
    double stiffness_Pa = 0.0;                             // fibre stiffness, > 0
    std::optional<FollowsDeclaration> follows;             // excludes `signal`
    std::optional<fibre::Signal> signal;  // a(t) in all trials; takes precedence over recorded actuation
    std::optional<std::filesystem::path> signal_file = {};  // the file `signal` was read from
    bool sought = true;  // whether `optimize` seeks its signal, unless it is told otherwise; its leader's counts
};

/// How an unknown transformation from camera frame to mesh frame is treated: bounded parameters of the fit, or a rigid
/// fit of the markers in their rest pose.
enum class RegistrationMethod { limited, rest_pose };

/// Transformation from the camera frame to the mesh frame. If it is known, the recordings are in the mesh frame.
struct RegistrationDeclaration {
    bool known = true;
    RegistrationMethod method = RegistrationMethod::limited;
    double max_translation_m = 0.0;  // bound per component, for `limited`
    double max_rotation_deg = 0.0;   // bound about the mesh origin, for `limited`; 0 ... 180
};

/// Compared quantity: marker positions, or displacements from the mean before the start of the motion.
enum class Comparison { position, displacement };

/// A marker by name with its position on the undeformed body.
struct MarkerDeclaration {
    std::string name;
    Eigen::Vector3d rest_m;  // mesh frame [m]
    std::string label;       // name in the recording; equals `name` unless markers.labels says otherwise
    bool probe = false;      // in no recording: only its simulated motion is wanted
};

/// All markers of the experiment and how their recorded motion is compared.
struct MarkersDeclaration {
    std::optional<double> noise_m;  // 1 sigma per coordinate; absent = estimated from the traces
    double max_standoff_m = 1e-3;   // largest distance of a rest position from the surface
    double placement_m = 0.0;       // 1 sigma per coordinate of where a marker sits against what is declared; 0: exact
    Comparison compare = Comparison::position;
    std::vector<MarkerDeclaration> on_body;  // move with the body, probes last; a recorded trial needs one that is none
    std::vector<MarkerDeclaration> fixed;    // attached to the surroundings, used for registration only
};

/// A mass glued to the surface, or a dead force of constant direction.
enum class LoadKind { mass, force };

/// Load spread over the part of the surface inside a box, in proportion to area.
/// Forces keep their direction and their material points; area is that of the undeformed surface.
struct LoadDeclaration {
    LoadKind kind = LoadKind::force;
    Box box_m;
    double mass_kg = 0.0;                                      // kind mass
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();         // kind force
    double from_s = -std::numeric_limits<double>::infinity();  // trial time at which a force starts
    double until_s = std::numeric_limits<double>::infinity();  // trial time at which a force ends, > from_s
    std::optional<fibre::Signal> curve;                        // factor of a force over trial time; excludes the two
};

/// A trial is fitted, or held out and predicted, or only simulated: it then has no recording.
enum class TrialRole { fit, validate, simulate };
/// The word of the declaration: "fit", "validate" or "simulate".
std::string to_string(TrialRole role);
/// The word for results: "fit", "predicted" or "simulated".
std::string result_word(TrialRole role);

/// A trial without a recording.
struct PlannedTrialPolicy {
    double rate_Hz = 100.0;  // of its output times, that of common camera systems
};
inline constexpr PlannedTrialPolicy planned_trial_policy;

/// State at t = 0: the undeformed body at rest, or static equilibrium under the loads of t = 0.
enum class StartState { straight, equilibrium };

/// Actuation that was not recorded: the actuator switches at t = 0 to a level that is given, or free (empty optional)
/// and then calibrated per trial.
struct ActuationStep {
    std::string muscle;           // name of a muscle that follows none, a chamber or a tendon
    std::optional<double> level;  // after the step: fibre stretch a [-], pressure [Pa], tension [N] or shortening [m]
};

/// Command of an actuator that is constant over a trial and before it, or follows a curve.
struct ConstantCommand {
    std::string actuator;  // name of a muscle, chamber or tendon
    double value = 0.0;    // activation a, pressure [Pa], tension [N] or shortening [m]; of a curve: that at t = 0
    std::string key = {};  // table of the trial that holds it: activation, pressure_Pa, tension_N or shortening_m
    std::optional<fibre::Signal> curve = {};  // over trial time, of chambers and tendons
};

/// One recorded run: its files, its time window, its actuation and its loads.
struct TrialDeclaration {
    std::string name;  // unique; results are written to <name>.csv
    TrialRole role = TrialRole::fit;
    double duration_s = 0.0;                           // of a trial without a recording; 0 for a hold and for others
    std::filesystem::path trace;                       // marker recording, resolved; empty: role simulate
    std::string format = "csv";                        // id of a reader, see trace_readers()
    std::optional<measurement::ColumnLayout> columns;  // for format `columns` only
    std::optional<double> metres_per_unit;             // `unit`: for a file that names none or an unknown one
    std::optional<double> seconds_per_unit;            // `time_unit` of the time column; empty: seconds
    /// `axes`: axes of the recording to the mesh frame, a right-handed signed permutation; empty: the same axes.
    std::optional<Eigen::Matrix3d> axes;
    StartState start = StartState::straight;
    double session_time_s = 0.0;                     // time of the trial within the session, for effects that drift
    std::optional<std::filesystem::path> actuation;  // recorded a(t) per muscle, resolved
    /// Content of `actuation` before there is such a file: of a trial that is only tried. No declaration has it.
    std::optional<measurement::ActuationTable> tried_actuation;
    std::vector<ActuationStep> actuation_steps;
    std::vector<ConstantCommand> constant_commands;
    bool hold = false;  // at rest all along: all samples are measurements of one pose; `start` is equilibrium
    std::optional<std::filesystem::path> sensors;  // recorded columns of the sensors, resolved
    std::map<std::string, double> sensor_values;   // readings of a hold, by column name
    std::optional<double> start_s;                 // file time that is t = 0
    std::optional<double> end_s;                   // file time of the last compared sample
    std::map<std::string, double> condition;       // test conditions by name; free levels are interpolated over them
    std::vector<LoadDeclaration> loads;
    std::vector<GoalDeclaration> goals;  // that `optimize` follows instead of the recording; times within the trial
    std::vector<measurement::TraceRepair> repairs;  // of the recording, in this order
};

/// A complete experiment folder after reading and checking. Names are unique and references between tables resolve.
struct Experiment {
    std::filesystem::path folder;  // the directory of experiment.toml
    std::string name;
    std::string description;
    Geometry geometry;
    Box clamp_box_m;  // nodes inside are held [m]; without [clamp] it holds no point, see has_clamp()
    std::vector<SupportDeclaration> supports;  // besides the clamp
    MaterialDeclaration material;
    Eigen::Vector3d gravity_m_s2{0.0, 0.0, -9.81};  // mesh frame
    std::vector<MuscleDeclaration> muscles;
    std::vector<ChamberDeclaration> chambers;
    std::vector<TendonDeclaration> tendons;
    std::vector<PartDeclaration> parts;
    MountMotion mount = MountMotion::fixed;
    std::vector<ObstacleDeclaration> obstacles;
    std::vector<SensorDeclaration> sensors;
    LimitsDeclaration limits;
    RegistrationDeclaration registration;
    std::vector<UnknownDeclaration> unknowns;  // bounds of fitted values
    MarkersDeclaration markers;
    std::vector<TrialDeclaration> trials;
    std::vector<effect::EffectDeclaration> effects;
    effect::Laws laws{};                             // entries in addition to those of the catalogue
    std::vector<std::filesystem::path> law_files{};  // of the laws, resolved
    std::vector<std::string> warnings;               // readable sentences; each starts with its key
    std::map<std::string, std::string>
        key_locations;  // "trial[2].load[0].box_m" -> "folder/experiment.toml:41", or "--set"
};

/// Markers that every recording holds: those on the body, then those on the mount.
inline std::vector<MarkerDeclaration> recorded_markers(const MarkersDeclaration& declared) {
    std::vector<MarkerDeclaration> markers;
    for (const auto* group : {&declared.on_body, &declared.fixed})
        std::copy_if(group->begin(), group->end(), std::back_inserter(markers),
                     [](const MarkerDeclaration& marker) { return !marker.probe; });
    return markers;
}

/// True if any trial has a recording.
inline bool has_recordings(const Experiment& experiment) {
    return std::any_of(experiment.trials.begin(), experiment.trials.end(),
                       [](const TrialDeclaration& trial) { return trial.role != TrialRole::simulate; });
}

/// True if there is a [clamp]; otherwise supports hold the body or obstacles bear it, and the clamp box has its corners
/// exchanged.
inline bool has_clamp(const Experiment& experiment) {
    return (experiment.clamp_box_m.lowest.array() <= experiment.clamp_box_m.highest.array()).all();
}

/// True if a clamp or a support holds the body.
inline bool is_held(const Experiment& experiment) { return has_clamp(experiment) || !experiment.supports.empty(); }

/// Boxes whose material cannot move at all: that of the clamp, and those of supports that hold all three axes.
inline std::vector<Box> clamped_boxes(const Experiment& experiment) {
    std::vector<Box> boxes;
    if (has_clamp(experiment)) boxes.push_back(experiment.clamp_box_m);
    for (const SupportDeclaration& support : experiment.supports)
        if (support.clamps()) boxes.push_back(support.box_m);
    return boxes;
}

}  // namespace myo::experiment
