#pragma once

#include <Eigen/Core>

#include <array>
#include <string>

namespace myo::ui::commands {

/// A goal of a trial, as declared: where a marker shall be.
struct SceneGoal {
    std::string marker;                          // name
    int number = -1;                             // index of the marker in Scene::markers
    Eigen::VectorXd time_s;                      // ascending [s]: one time, the two ends of a span, or those of a path
    Eigen::Matrix3Xd place_m;                    // one per time, 3 x n [m]; linear between the times
    double weight = 1.0;                         // of the squared distance, against other goals
    bool is_path = false;                        // several places; otherwise one
    bool from_file = false;                      // the path is read from a file
    std::array<bool, 3> axes{true, true, true};  // coordinates that count
};

}  // namespace myo::ui::commands
