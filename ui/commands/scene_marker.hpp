#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::ui::commands {

struct SceneMarker {
    std::string name;
    Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();
};

}  // namespace myo::ui::commands
