#pragma once

#include "inverse/marker_target.hpp"

namespace myo::inverse {

/// Bounds of a placement, along and about each axis.
struct PlacementBounds {
    double translation_m = 0.0;
    double rotation_rad = 0.0;
};

/// Placement (translation and rotation) within the bounds that minimises the distance between the markers of a motion
/// and their target, by Gauss-Newton iterations from zero. The time shift is not changed. For displacement targets the
/// given placement is returned.
///
/// At this minimum the derivative of mean_square() with respect to the placement vanishes or points out of the bounds.
/// Hence the derivative of the minimised loss with respect to the motion is that at fixed placement.
MarkerPlacement best_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion,
                               const PlacementBounds& bounds);

/// Whether a component of the placement that has room is at its bound.
bool at_bound(const MarkerPlacement& placement, const PlacementBounds& bounds);

/// Derivative of a placed marker with respect to translation and rotation, 3 x 6. `x`: marker position in the model
/// [m].
Eigen::Matrix<double, 3, 6> placement_tangent(const MarkerPlacement& placement, const Eigen::Vector3d& x);

}  // namespace myo::inverse
