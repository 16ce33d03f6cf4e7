#include "measurement/rigid_motion.hpp"

#include <cmath>

namespace myo::measurement {
namespace {

// sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3 without cancellation at small angles.
struct RotationSeries {
    double sine;
    double versine;
    double remainder;
};

RotationSeries rotation_series(double angle) {
    const double s = angle * angle;
    if (angle < 0.1) {  // first neglected terms are below 1e-16
        return {1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0))),
                0.5 - s / 24.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0))),
                1.0 / 6.0 - s / 120.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0)))};
    }
    return {std::sin(angle) / angle, (1.0 - std::cos(angle)) / s, (angle - std::sin(angle)) / (s * angle)};
}

}  // namespace

Eigen::Vector3d RigidMotion::apply(const Eigen::Vector3d& p) const { return rotation * p + translation; }

Eigen::Matrix3Xd RigidMotion::apply_all(const Eigen::Matrix3Xd& points) const {
    return (rotation * points).colwise() + translation;
}

RigidMotion RigidMotion::inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }

RigidMotion compose(const RigidMotion& second, const RigidMotion& first) {
    return {second.rotation * first.rotation, second.rotation * first.translation + second.translation};
}

double rotation_angle(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d axis(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                               rotation(1, 0) - rotation(0, 1));
    // acos of the trace would lose half of the digits at small angles.
    return std::atan2(axis.norm(), rotation.trace() - 1.0);  // twice the sine and twice the cosine
}

Eigen::Matrix3d small_rotation(const Eigen::Vector3d& omega) {
    // Rodrigues' formula: R = I + sin(a)/a W + (1 - cos a)/a^2 W^2.
    const RotationSeries series = rotation_series(omega.norm());
    const Eigen::Matrix3d W = cross_matrix(omega);
    return Eigen::Matrix3d::Identity() + series.sine * W + series.versine * W * W;
}

Eigen::Matrix3d d_rotated_d_omega(const Eigen::Vector3d& omega, const Eigen::Vector3d& p) {
    const RotationSeries series = rotation_series(omega.norm());
    const Eigen::Matrix3d W = cross_matrix(omega);
    const Eigen::Matrix3d left_jacobian = Eigen::Matrix3d::Identity() + series.versine * W + series.remainder * W * W;
    const Eigen::Vector3d rotated = p + series.sine * W * p + series.versine * (W * (W * p));
    return -cross_matrix(rotated) * left_jacobian;
}

}  // namespace myo::measurement
