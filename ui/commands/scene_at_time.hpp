#pragma once

#include <Eigen/Core>

#include <vector>

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo {

/// Two neighbouring samples and the weight of the later one; index -1 when there are none. Outside the range: its end.
struct TimePlace {
    Eigen::Index index = -1;
    Eigen::Index next = -1;
    double weight = 0.0;
};
TimePlace place_in_time(const Eigen::VectorXd& time_s, double t);

/// Linear between samples; NaN when either is. Asserts a place.
Eigen::Vector3d at_time(const Eigen::Matrix3Xd& track, const TimePlace& place);

/// Node positions at the current time; the rest shape without a run.
Eigen::Matrix3Xd positions_at_time(const WorkbenchState& state);

/// The 3D picture of the state's trial at its time.
/// @param surface  the triangles of the state's body or, without one, of its surface; may be null
DrawnScene scene_at_time(const WorkbenchState& state, const Theme& theme, std::shared_ptr<const DrawnSurface> surface);

}  // namespace myo
