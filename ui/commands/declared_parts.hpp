#pragma once

#include <Eigen/Core>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fibre/signal.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::ui::commands {

/// A tendon as declared.
struct DeclaredTendon {
    std::string name;
    Eigen::Matrix3Xd path_m;              // guides at rest, 3 x n [m], motor's end first
    bool by_shortening = false;           // what the motor prescribes; otherwise the tension
    std::optional<double> stiffness_N_m;  // empty: the thread does not stretch
    double friction = 0.0;                // capstan coefficient at the guides
    bool channel = false;                 // follows the material between its guides
};

/// A closed cavity of the body's surface.
struct SceneCavity {
    mesh::SurfaceMesh wall;                              // triangles of the body's surface around it, vertices [m]
    Eigen::Vector3d inside_m = Eigen::Vector3d::Zero();  // a point in it
    double volume_m3 = 0.0;                              // at rest
    double area_m2 = 0.0;                                // of the wall at rest
    std::string chamber;                                 // name of the chamber that it is; empty: none
};

/// What a trial declares as the command of a chamber or tendon.
struct DeclaredCommand {
    enum class Kind { constant, step, curve, file };
    Kind kind = Kind::constant;  // also before t = 0; from t = 0 on; over time; a column of the trial's actuation file
    double value = 0.0;          // SI; of a file: 0; of a curve: at t = 0
    fibre::Signal curve = {};    // SI, of a curve
};

/// Parts of an experiment's declaration that panels and tools of the window edit.
struct DeclaredParts {
    double max_standoff_m = 1e-3;       // of markers and guides that move with the body
    std::vector<std::string> muscles;   // names in the order of declaration
    std::vector<std::string> chambers;  // the same
    std::vector<DeclaredTendon> tendons;
    std::vector<SceneCavity> cavities;
    std::set<std::string> kept;            // muscles, chambers and tendons whose signals are not sought
    std::map<std::string, double> limits;  // of sought signals, by key: "pressure_Pa", "tension_N", "shortening_m"
    std::vector<std::map<std::string, DeclaredCommand>> commands;  // per trial, by the name of chamber or tendon
};

}  // namespace myo::ui::commands
