#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fibre/painted_mask.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

// What a soft robot has beyond one material, muscles and a clamp, as declared. SI units, mesh frame.

/// Closed cavity inside the body, under gauge pressure.
struct ChamberDeclaration {
    std::string name;          // its column of an actuation file is "<name>_Pa"
    Eigen::Vector3d inside_m;  // any point of the cavity [m]
    bool sought = true;        // whether `optimize` seeks its signal, unless it is told otherwise
};

/// What the motor of a tendon prescribes: the tension [N], or the length it takes in from the rest length [m].
enum class TendonDrive { tension, shortening };

/// Thread that pulls the body together along its path; it never pushes. The motor is at the first guide, the anchor at
/// the last; between guides the thread is straight.
struct TendonDeclaration {
    std::string name;         // its column of an actuation file is "<name>_N" or "<name>_m"
    Eigen::Matrix3Xd path_m;  // guides at rest, 3 x n, n >= 2
    TendonDrive drive = TendonDrive::tension;
    std::optional<double> stiffness_N_m;  // of the whole thread, for `shortening`; absent: it does not stretch
    double friction = 0.0;                // capstan coefficient at the guides, >= 0
    bool sought = true;                   // as for chambers
    bool channel = false;                 // between its guides it follows the material, as in a channel of the body
};

/// Part of the body with a material of its own; of parts that overlap, the later one counts.
struct PartDeclaration {
    /// Cells with a number of a volume mesh.
    struct Region {
        int number = 0;
    };
    /// Cells painted with weights, in a file of the form that masks of muscles have; its fibres have no meaning.
    struct Painted {
        std::variant<std::filesystem::path, std::shared_ptr<const fibre::PaintedMask>>
            mask;  // a file, resolved, or what it would hold; never null
    };
    std::string name;
    // A path: closed surface in the geometry's unit and frame.
    std::variant<Box, std::filesystem::path, Region, Painted> place;
    double youngs_modulus_Pa = 0.0;         // > 0
    double youngs_modulus_tolerance = 0.3;  // relative half-width
    double poissons_ratio = 0.0;            // strictly between 0 and 0.5
    double density_kg_m3 = 0.0;             // > 0
    std::optional<double> damping_s;        // Kelvin-Voigt damping time [s]; absent: the material's
    std::vector<std::string> calibrate;     // parameters to fit: of youngs_modulus, damping
};

/// A further place where the body is held, such as a roller: material in the box does not move along the held axes.
struct SupportDeclaration {
    Box box_m;                                   // a side without depth selects the nodes in a plane or on a line
    std::array<bool, 3> held{true, true, true};  // per axis of the mesh frame, at least one

    bool clamps() const { return held[0] && held[1] && held[2]; }
};

/// How the clamped region moves: not at all, or rigidly as the fixed markers were seen to.
enum class MountMotion { fixed, markers };

/// Rigid obstacle that stands still.
struct ObstacleDeclaration {
    /// Half-space behind a plane.
    struct Plane {
        Eigen::Vector3d point_m;  // any point of the plane
        Eigen::Vector3d normal;   // unit, towards the body
    };
    /// Solid ball.
    struct Sphere {
        Eigen::Vector3d centre_m;
        double radius_m = 0.0;  // > 0
    };
    std::variant<Plane, Sphere, Box> shape;
    double friction = 0.0;  // Coulomb coefficient, >= 0
};

/// What a sensor measures in addition to the markers. A reaction is the force of the support on the body.
enum class SensorKind { reaction, chamber_volume, tendon_tension, tendon_shortening };

/// Sensor that is compared, weighed and fitted like the markers.
struct SensorDeclaration {
    std::string name;  // heads its columns: "<name>_x_N" ..., "<name>_m3", "<name>_N", "<name>_m"
    SensorKind kind = SensorKind::reaction;
    std::string of;      // chamber or tendon; empty for a reaction
    double noise = 0.0;  // 1 sigma in the unit of the column, > 0
};

/// What a proposed trial, or a signal that is sought, may use at most; SI units. Empty: nothing is declared.
struct LimitsDeclaration {
    std::optional<double> force_N, mass_kg, duration_s;          // > 0
    std::optional<double> pressure_Pa, tension_N, shortening_m;  // largest magnitude, > 0
    std::optional<double> activation;                            // lowest of any muscle, 0 < a < 1
};

}  // namespace myo::experiment
