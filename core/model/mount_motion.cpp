#include "model/mount_motion.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <utility>

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// See with_vibrations().
class VibratingMount : public MountMotion {
public:
    VibratingMount(MountMotionPointer motion, std::vector<MountVibration> vibrations)
        : motion_(std::move(motion)), vibrations_(std::move(vibrations)) {}

    MountPose at(double time_s) const override {
        // A mount without a motion of its own stands at the origin of the laboratory, unturned.
        MountPose pose = motion_ ? motion_->at(time_s) : MountPose{};
        for (const MountVibration& vibration : vibrations_) {
            const double omega = 2.0 * std::numbers::pi * vibration.frequency_Hz;
            const double angle = omega * time_s + vibration.phase_rad;
            pose.place_m += std::sin(angle) * vibration.amplitude_m;
            pose.velocity_m_s += omega * std::cos(angle) * vibration.amplitude_m;
            pose.acceleration_m_s2 -= omega * omega * std::sin(angle) * vibration.amplitude_m;
        }
        return pose;
    }
    bool turns() const override { return motion_ && motion_->turns(); }

private:
    MountMotionPointer motion_;
    std::vector<MountVibration> vibrations_;
};

/// See by_clock(). By the chain rule each derivative in time gets one factor of the rate.
class ClockedMount : public MountMotion {
public:
    ClockedMount(MountMotionPointer motion, double offset_s, double rate)
        : motion_(std::move(motion)), offset_s_(offset_s), rate_(rate) {}

    MountPose at(double time_s) const override {
        MountPose pose = motion_->at(rate_ * (time_s - offset_s_));
        pose.velocity_m_s *= rate_;
        pose.spin_rad_s *= rate_;
        pose.acceleration_m_s2 *= rate_ * rate_;
        pose.spin_rate_rad_s2 *= rate_ * rate_;
        return pose;
    }
    bool turns() const override { return motion_->turns(); }

private:
    MountMotionPointer motion_;
    double offset_s_, rate_;
};

}  // namespace

Matrix3Xd MountPose::in_laboratory(const Matrix3Xd& X) const {
    return (rotation * (X.colwise() - pivot_m)).colwise() + place_m;
}

Matrix3Xd MountPose::velocities_in_laboratory(const Matrix3Xd& X, const Matrix3Xd& V) const {
    Matrix3Xd v(3, X.cols());
    for (Eigen::Index i = 0; i < X.cols(); ++i)
        v.col(i) = velocity_m_s + rotation * (V.col(i) + spin_rad_s.cross(Vector3d(X.col(i) - pivot_m)));
    return v;
}

MountMotionPointer with_vibrations(MountMotionPointer motion, const std::vector<MountVibration>& vibrations) {
    if (vibrations.empty()) return motion;
    return std::make_shared<VibratingMount>(std::move(motion), vibrations);
}

MountMotionPointer by_clock(MountMotionPointer motion, double offset_s, double rate) {
    if (!motion || (offset_s == 0.0 && rate == 1.0)) return motion;
    return std::make_shared<ClockedMount>(std::move(motion), offset_s, rate);
}

}  // namespace myo::model
