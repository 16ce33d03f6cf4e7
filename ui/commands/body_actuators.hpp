#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::ui::commands {

/// Guide of a thread: it moves with nodes of the mesh, or stands still.
struct ThreadGuide {
    std::vector<int> nodes;                            // of the mesh; none: it stands still
    Eigen::VectorXd weights;                           // per node, sum to 1
    Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();  // place at rest [m], mesh frame
    bool declared = true;                              // otherwise a point on the way through a channel
};

/// A tendon on the meshed body.
struct ShownTendon {
    std::string name;
    std::vector<ThreadGuide> guides;  // motor's end first
};

/// A chamber of the meshed body.
struct ShownChamber {
    std::string name;
    std::vector<int> walls;     // faces of MeshedBody::boundary
    double volume_m3 = 0.0;     // at rest
    double wall_area_m2 = 0.0;  // at rest
};

/// What drives the body in addition to muscles, on its mesh.
struct BodyActuators {
    std::vector<ShownChamber> chambers;
    std::vector<ShownTendon> tendons;

    /// Whether nothing but muscles drives the body.
    bool empty() const { return chambers.empty() && tendons.empty(); }
    /// Number of chambers and tendons together.
    std::size_t count() const { return chambers.size() + tendons.size(); }
};

}  // namespace myo::ui::commands
