#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::ui::commands {

/// A marker of an experiment and its position at rest in the mesh frame.
struct SceneMarker {
    std::string name;
    Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();  // [m]
    std::string label = {};                            // in the recordings
    bool probe = false;                                // in no recording, by its declaration
};

}  // namespace myo::ui::commands
