#pragma once

#include "inverse/marker_target.hpp"

namespace myo::inverse {

/// How far a placement may move and turn, along and about each axis.
struct PlacementBounds {
    double translation_m = 0.0;
    double rotation_rad = 0.0;
};

/// The translation and rotation within the bounds that bring the markers of a motion nearest to their target, by
/// Gauss-Newton steps from none; the start shift stays. Displacements are not placed: their placement is returned as it
/// is.
///
/// At this minimum the derivative of mean_square() by the placement vanishes, or points out of the bounds: its
/// derivative by the motion is that of the loss with the placement held.
MarkerPlacement best_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion,
                               const PlacementBounds& bounds);

/// Whether a component stands at its bound.
bool at_bound(const MarkerPlacement& placement, const PlacementBounds& bounds);

/// Derivative of a placed marker by translation and rotation, 3 x 6. @param x  where it is in the model
Eigen::Matrix<double, 3, 6> placement_tangent(const MarkerPlacement& placement, const Eigen::Vector3d& x);

}  // namespace myo::inverse
