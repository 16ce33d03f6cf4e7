#pragma once

#include <Eigen/Core>

namespace myo::ui::commands {

/// Cuts whole elements away: those whose middle at rest lies beyond the plane, so that what is seen does not change
/// while the body moves.
struct ClipPlane {
    bool on = false;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit, mesh frame
    double position_m = 0.0;                            // of the plane along the normal, normal . X
    bool flip = false;                                  // what lies before the plane is cut away instead

    bool removes(const Eigen::Vector3d& rest_m) const { return (normal.dot(rest_m) > position_m) != flip; }
    bool operator==(const ClipPlane&) const = default;
};

}  // namespace myo::ui::commands
