#pragma once

#include <filesystem>

#include "measurement/observe.hpp"
#include "model/model.hpp"
#include "reproduce/reproduction.hpp"
#include "setup/body_mesh.hpp"

namespace myo::reproduce {

/// A robot of the paper: a body of silicone held at one face, with two antagonist muscles along z, and the point of it
/// that is tracked.
struct MuscleRobot {
    std::string id;                        // of the robot's warnings
    std::string geometry;                  // file below data/geometry, in mm
    Box clamp;                             // [m]
    Box first, second;                     // the muscles' boxes on the body [m]
    double published_edge_m = 0.0;         // of the paper's cubes
    double gravity_m_s2 = -9.81;           // along z
    std::vector<Eigen::Vector3d> tracked;  // the tracked point is the mean of these points of the body [m]
    std::vector<Eigen::Vector3d> markers;  // that moved, where they were placed at rest [m]
    double bends_to = 1.0;                 // along x, when the first muscle grows longer: 1 or -1
};

/// The pneumatic arm: hangs from z = 0.1 m and bends towards -x when the first muscle, at +x, grows longer. Its tip
/// centre is the mean of the middles of the lower face's sides. Source: the public scripts of Dubied et al. 2022.
const MuscleRobot& paper_arm();

/// The fish tail: stands on z = 0 and bends towards +x when the first muscle, at -x, grows longer. Tracked: the marker
/// on its spine.
const MuscleRobot& paper_fish();

/// The file of the robot's geometry, whether it is there or not.
std::filesystem::path geometry_file(const ReproduceSettings& settings, const MuscleRobot& robot);

/// How it is modelled.
struct MuscleBodyOptions {
    bool published = false;  // whole cubes, full integration, projective energy, equal vertex masses; else the body as
                             // it is
    int muscles = 2;         // 1: the first alone
    double edge_m = 0.0;     // of the cells; 0: the paper's
    double youngs_modulus_Pa = 263824.0;
    double damping_s = 0.0;
};

struct MuscleBody {
    model::Model model;             // all muscles passive: a = 1
    measurement::MarkerSet points;  // the tracked point, then the robot's markers
};

/// Errors: those of the geometry file and of the mesher.
Result<MuscleBody> make_muscle_body(const ReproduceSettings& settings, const MuscleRobot& robot,
                                    const MuscleBodyOptions& options);

/// What a user reads when the geometry is not there.
std::string missing_geometry(const ReproduceSettings& settings, const MuscleRobot& robot);

}  // namespace myo::reproduce
