#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace myo::experiment {

/// Where a marker shall be in a trial: at one place at a time, at one place over a span, or along a path.
struct GoalDeclaration {
    std::string marker;                          // name of a marker on the body
    Eigen::VectorXd times_s;                     // trial times, ascending [s]; one, or from the first to the last
    Eigen::Matrix3Xd places_m;                   // one per time, 3 x n [m], mesh frame; linear between the times
    double weight = 1.0;                         // of the goal as a whole, > 0
    std::array<bool, 3> axes{true, true, true};  // coordinates that count
    bool is_path = false;                        // declared over time; otherwise one place
    std::optional<std::filesystem::path> file;   // of a path, resolved
};

/// Place of a goal at a trial time [s] within its span, in the mesh frame [m]. Outside of the span it is that of the
/// nearest end. Asserts at least one time, and one place per time.
Eigen::Vector3d place_at(const GoalDeclaration& goal, double time_s);

}  // namespace myo::experiment
