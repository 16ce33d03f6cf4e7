#pragma once

#include <Eigen/Core>

namespace myo::ui::commands {

/// A plane that cuts the drawn body open. It removes whole elements whose centre at rest lies beyond the plane, so that
/// the visible part does not change while the body moves.
struct ClipPlane {
    bool on = false;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit vector, mesh frame
    double position_m = 0.0;                            // n . X of the plane [m]
    bool flip = false;                                  // removes the elements on the other side instead

    /// Whether an element with this centre at rest [m] is removed.
    bool removes(const Eigen::Vector3d& rest_m) const { return (normal.dot(rest_m) > position_m) != flip; }
    bool operator==(const ClipPlane&) const = default;
};

}  // namespace myo::ui::commands
