#pragma once

#include <Eigen/Geometry>

#include <cmath>

#include "model/mount_motion.hpp"

namespace myo::test {

/// A mount that turns about a fixed axis through a pivot, which moves along a line: angle(t) = spin t + swing sin(w t),
/// place(t) = drift t + 1/2 push t^2 + shake (cos(w t) - 1).
struct TurningMount : model::MountMotion {
    Eigen::Vector3d axis = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
    Eigen::Vector3d pivot_m{0.01, -0.02, 0.015};
    double spin_rad_s = 0.0, swing_rad = 0.0, omega_rad_s = 0.0;
    Eigen::Vector3d drift_m_s{0.0, 0.0, 0.0}, push_m_s2{0.0, 0.0, 0.0}, shake_m{0.0, 0.0, 0.0};

    model::MountPose at(double t) const override {
        const double w = omega_rad_s, s = std::sin(w * t), c = std::cos(w * t);
        model::MountPose pose;
        pose.pivot_m = pivot_m;
        pose.rotation = Eigen::AngleAxisd(spin_rad_s * t + swing_rad * s, axis).toRotationMatrix();
        pose.spin_rad_s = (spin_rad_s + swing_rad * w * c) * axis;
        pose.spin_rate_rad_s2 = -swing_rad * w * w * s * axis;
        pose.place_m = pivot_m + drift_m_s * t + 0.5 * push_m_s2 * t * t + shake_m * (c - 1.0);
        pose.velocity_m_s = drift_m_s + push_m_s2 * t - shake_m * w * s;
        pose.acceleration_m_s2 = push_m_s2 - shake_m * w * w * c;
        return pose;
    }
    bool turns() const override { return spin_rad_s != 0.0 || swing_rad != 0.0; }
};

/// All parts of the motion at once.
inline std::shared_ptr<TurningMount> tumbling_mount() {
    auto mount = std::make_shared<TurningMount>();
    mount->spin_rad_s = 3.0;
    mount->swing_rad = 0.4;
    mount->omega_rad_s = 20.0;
    mount->drift_m_s = {0.1, 0.2, -0.1};
    mount->push_m_s2 = {1.0, -2.0, 3.0};
    mount->shake_m = {0.004, 0.003, -0.002};
    return mount;
}

}  // namespace myo::test
