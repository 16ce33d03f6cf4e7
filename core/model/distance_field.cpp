#include "model/distance_field.hpp"

#include <cassert>
#include <cmath>

namespace myo::model {

using Eigen::Matrix3d;
using Eigen::Vector3d;

DistanceField plane_distance(const Vector3d& point_m, const Vector3d& normal) {
    assert(normal.norm() > 0.0);
    return [point_m, n = Vector3d(normal.normalized())](const Vector3d& x) {
        return SignedDistance{n.dot(x - point_m), n, Matrix3d::Zero()};
    };
}

DistanceField sphere_distance(const Vector3d& centre_m, double radius_m) {
    assert(radius_m > 0.0);
    return [centre_m, radius_m](const Vector3d& x) {
        const Vector3d arm = x - centre_m;
        const double r = arm.norm();
        // The centre itself has no nearest point; any will do.
        if (!(r > 0.0)) return SignedDistance{-radius_m, Vector3d::UnitZ(), Matrix3d::Zero()};
        const Vector3d n = arm / r;
        return SignedDistance{r - radius_m, n, (Matrix3d::Identity() - n * n.transpose()) / r};
    };
}

DistanceField box_distance(const Vector3d& lowest_m, const Vector3d& highest_m, double rounding_m) {
    const Vector3d middle = 0.5 * (lowest_m + highest_m), half = 0.5 * (highest_m - lowest_m);
    assert(rounding_m > 0.0 && rounding_m < half.minCoeff());
    // The rounded box is all that lies within `rounding_m` of a smaller one.
    return [middle, core = Vector3d(half.array() - rounding_m), rounding_m](const Vector3d& x) {
        // By symmetry in the octant of positive coordinates: `beyond` points from the smaller box to x.
        const Vector3d from = x - middle, outside = from.cwiseAbs() - core, beyond = outside.cwiseMax(0.0);
        const auto sign = [&](int axis) { return from(axis) < 0.0 ? -1.0 : 1.0; };
        SignedDistance result;
        const double r = beyond.norm();
        result.distance_m = r - rounding_m;
        if (!(r > 0.0)) {
            // Inside the smaller box: out through the nearest face.
            int axis = 0;
            result.distance_m = outside.maxCoeff(&axis) - rounding_m;
            result.normal = sign(axis) * Vector3d::Unit(axis);
            return result;
        }
        Matrix3d across = Matrix3d::Zero();
        for (int axis = 0; axis < 3; ++axis) {
            result.normal(axis) = sign(axis) * beyond(axis) / r;
            // Only along axes on which x lies beyond the smaller box does the nearest point stand still.
            if (beyond(axis) > 0.0) across(axis, axis) = 1.0;
        }
        result.curvature_1_m = (across - result.normal * result.normal.transpose()) / r;
        return result;
    };
}

}  // namespace myo::model
