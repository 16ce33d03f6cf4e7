#pragma once

#include <filesystem>

#include "measurement/observe.hpp"
#include "model/model.hpp"
#include "reproduce/reproduction.hpp"
#include "setup/body_mesh.hpp"

namespace myo::reproduce {

/// A robot of the paper: a silicone body clamped at one face, with two antagonist muscles along z and a tracked point.
struct MuscleRobot {
    std::string id;        // for messages
    std::string geometry;  // file below data/geometry, in mm
    Box clamp;             // clamp box [m]
    // A muscle fills the part of the body inside its box.
    Box first, second;                     // muscle boxes on the body [m]
    double published_edge_m = 0.0;         // edge of the paper's cubes
    double gravity_m_s2 = -9.81;           // along z
    std::vector<Eigen::Vector3d> tracked;  // the tracked point is the mean of these points [m]
    std::vector<Eigen::Vector3d> markers;  // moving markers, rest positions [m]
    double bends_to = 1.0;                 // direction along x when the first muscle lengthens: 1 or -1
};

/// The pneumatic arm: hangs from z = 0.1 m and bends towards -x when the first muscle, at +x, lengthens. Its tip centre
/// is the mean of the midpoints of the lower face's edges. Source: the public scripts of Dubied et al. 2022.
const MuscleRobot& paper_arm();

/// The fish tail: stands on z = 0 and bends towards +x when the first muscle, at -x, lengthens. The tracked point is
/// the marker on its spine.
const MuscleRobot& paper_fish();

/// Path of the robot's geometry; the file need not exist.
std::filesystem::path geometry_file(const ReproduceSettings& settings, const MuscleRobot& robot);

/// How the robot is modelled.
struct MuscleBodyOptions {
    bool published = false;  // whole cubes, full integration, projective energy, equal vertex masses
    int muscles = 2;         // 1: the first only
    double edge_m = 0.0;     // of the cells; 0: that of the paper
    // Modulus of the paper's silicone, fitted with a commercial solver.
    double youngs_modulus_Pa = 263824.0;
    double damping_s = 0.0;
};

/// A robot's model with its observed points.
struct MuscleBody {
    model::Model model;             // all muscles passive: a = 1
    measurement::MarkerSet points;  // tracked point, then the robot's markers
};

/// Meshes the robot and builds its model, clamped and under gravity.
///
/// Errors: those of the geometry file and of the mesher; a muscle without cells.
Result<MuscleBody> make_muscle_body(const ReproduceSettings& settings, const MuscleRobot& robot,
                                    const MuscleBodyOptions& options);

/// Message for the user if the geometry file is missing.
std::string missing_geometry(const ReproduceSettings& settings, const MuscleRobot& robot);

}  // namespace myo::reproduce
