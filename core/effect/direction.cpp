#include "effect/direction.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace myo::effect {
namespace {

using Eigen::Matrix;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Orthonormal basis of the tangent plane at the base: the directions of the two angles.
/// The axis least aligned with the base gives the best conditioned cross product. It changes where two components are
/// equal, but the base of a fit is constant.
Matrix<double, 3, 2> tangents(const Vector3d& base) {
    int least = 0;
    base.cwiseAbs().minCoeff(&least);
    Matrix<double, 3, 2> result;
    result.col(0) = base.cross(Vector3d::Unit(least)).normalized();
    result.col(1) = base.cross(result.col(0));
    return result;
}

}  // namespace

Vector3d direction_at(const Vector3d& base, const Vector2d& angles_rad) {
    const double angle = angles_rad.norm();
    if (angle == 0.0) return base;
    // Exponential map of the sphere; normalised against rounding.
    return (std::cos(angle) * base + std::sin(angle) / angle * (tangents(base) * angles_rad)).normalized();
}

Vector2d direction_angles(const Vector3d& base, const Vector3d& direction) {
    const Vector2d across = tangents(base).transpose() * direction;
    const double along = base.dot(direction), size = across.norm();
    if (size == 0.0) return along < 0.0 ? Vector2d(std::numbers::pi, 0.0) : Vector2d(Vector2d::Zero());
    // atan2 is accurate for small angles and for angles near pi.
    return std::atan2(size, along) / size * across;
}

}  // namespace myo::effect
