#pragma once

#include <Eigen/Core>

#include <functional>

namespace myo::model {

/// Signed distance from a rigid obstacle with its derivatives.
struct SignedDistance {
    double distance_m = 0.0;                                  // negative inside
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();         // gradient, a unit vector away from the obstacle
    Eigen::Matrix3d curvature_1_m = Eigen::Matrix3d::Zero();  // Hessian, positive semidefinite outside
};

/// Signed distance of a point [m].
using DistanceField = std::function<SignedDistance(const Eigen::Vector3d&)>;

/// Half-space behind a plane; it has no far side. `normal`: any length but 0, away from the half-space.
DistanceField plane_distance(const Eigen::Vector3d& point_m, const Eigen::Vector3d& normal);

/// Ball. A point deeper than the centre is on the far side: what passes the centre within a step leaves there.
DistanceField sphere_distance(const Eigen::Vector3d& centre_m, double radius_m);

/// Box whose edges and corners are rounded by `rounding_m`, less than half of its shortest side.
///
/// Deeper inside than the rounding, the nearest face is the way out; its choice jumps on the medial planes. The
/// curvature jumps where a face meets a rounded edge, the normal does not.
DistanceField box_distance(const Eigen::Vector3d& lowest_m, const Eigen::Vector3d& highest_m, double rounding_m);

}  // namespace myo::model
