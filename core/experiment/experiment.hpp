#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "effect/effect.hpp"
#include "fibre/painted_mask.hpp"
#include "fibre/polyline.hpp"
#include "fibre/signal.hpp"
#include "measurement/trace_file.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// The declarations of an experiment folder, value for value (schema experiment/1). SI units, mesh frame.

struct BoxGeometry {
    Eigen::Vector3d size_m;
    Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

struct StlGeometry {
    std::filesystem::path file;    // as resolved against the folder
    double metres_per_unit = 1.0;  // 1 or 1e-3
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

struct MaterialDeclaration {
    std::string model;  // id in the material catalogue
    double youngs_modulus_Pa = 0.0;
    double youngs_modulus_tolerance = 0.3;  // relative half-width
    double poissons_ratio = 0.0;
    double density_kg_m3 = 0.0;
    std::optional<double> damping_s;  // absent = unknown
    std::vector<std::string> calibrate = {"youngs_modulus", "damping"};
};

/// a - 1 of a group is ratio times (a - 1) of another.
struct FollowsDeclaration {
    std::string muscle;
    double ratio = 0.0;
};

/// The part of the body inside a box.
struct MuscleBox {
    Box box_m;
    Eigen::Vector3d fibre;  // unit
};

/// Elements painted one by one.
struct MuscleMask {
    std::variant<std::filesystem::path, std::shared_ptr<const fibre::PaintedMask>>
        painted;                           // a file, resolved, or what it would hold; never null
    std::optional<Eigen::Vector3d> fibre;  // unit; instead of the painted directions
};

/// All material within a radius of a line; fibres run along it.
struct MuscleLine {
    fibre::Polyline line;
    double radius_m = 0.0;
};

struct MuscleDeclaration {
    std::string name;
    std::variant<MuscleBox, MuscleMask, MuscleLine> part;
    double stiffness_Pa = 0.0;
    std::optional<FollowsDeclaration> follows;
    std::optional<fibre::Signal> signal;                    // a(t) in all trials, whatever these recorded
    std::optional<std::filesystem::path> signal_file = {};  // that it was read from
};

enum class RegistrationMethod { limited, rest_pose };

struct RegistrationDeclaration {
    bool known = true;
    RegistrationMethod method = RegistrationMethod::limited;
    double max_translation_m = 0.0;  // for `limited`
    double max_rotation_deg = 0.0;   // about the mesh origin
};

enum class Comparison { position, displacement };

struct MarkerDeclaration {
    std::string name;
    Eigen::Vector3d rest_m;
    std::string label;  // name in the recording; equals `name` unless markers.labels says otherwise
};

struct MarkersDeclaration {
    std::optional<double> noise_m;
    double max_standoff_m = 1e-3;
    Comparison compare = Comparison::position;
    std::vector<MarkerDeclaration> on_body;
    std::vector<MarkerDeclaration> fixed;
};

enum class LoadKind { mass, force };

struct LoadDeclaration {
    LoadKind kind = LoadKind::force;
    Box box_m;
    double mass_kg = 0.0;                               // kind mass
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();  // kind force
    double from_s = -std::numeric_limits<double>::infinity();
    double until_s = std::numeric_limits<double>::infinity();
};

enum class TrialRole { fit, validate };
enum class StartState { straight, equilibrium };

/// A level that was not recorded: a number, or free (empty optional), calibrated per trial.
struct ActuationStep {
    std::string muscle;
    std::optional<double> level;
};

struct TrialDeclaration {
    std::string name;
    TrialRole role = TrialRole::fit;
    std::filesystem::path trace;  // resolved
    measurement::TraceFormat format = measurement::TraceFormat::csv;
    std::optional<measurement::ColumnLayout> columns;
    StartState start = StartState::straight;
    double session_time_s = 0.0;
    std::optional<std::filesystem::path> actuation;  // resolved
    std::vector<ActuationStep> actuation_steps;
    std::optional<double> start_s;  // file time that is t = 0
    std::optional<double> end_s;    // file time
    std::map<std::string, double> condition;
    std::vector<LoadDeclaration> loads;
};

struct Experiment {
    std::filesystem::path folder;
    std::string name;
    std::string description;
    std::variant<BoxGeometry, StlGeometry> geometry;
    Box clamp_box_m;
    MaterialDeclaration material;
    Eigen::Vector3d gravity_m_s2{0.0, 0.0, -9.81};
    std::vector<MuscleDeclaration> muscles;
    RegistrationDeclaration registration;
    MarkersDeclaration markers;
    std::vector<TrialDeclaration> trials;
    std::vector<effect::EffectDeclaration> effects;
    std::vector<std::string> warnings;  // for a person; each names its key
    std::map<std::string, std::string>
        key_locations;  // "trial[2].load[0].box_m" -> "folder/experiment.toml:41", or "--set"
};

}  // namespace myo::experiment
