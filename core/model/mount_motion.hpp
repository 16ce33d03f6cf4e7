#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace myo::model {

/// Where the mount is at an instant: a point at X in the mount's frame lies at rotation (X - pivot_m) + place_m in the
/// laboratory. The mount's frame is the mesh frame and moves with the mount.
struct MountPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();            // constant in time, mount's frame
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();            // of the pivot, laboratory
    Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();       // of the pivot, laboratory
    Eigen::Vector3d acceleration_m_s2 = Eigen::Vector3d::Zero();  // of the pivot, laboratory
    Eigen::Vector3d spin_rad_s = Eigen::Vector3d::Zero();         // angular velocity, in the mount's frame
    Eigen::Vector3d spin_rate_rad_s2 = Eigen::Vector3d::Zero();   // its time derivative, in the mount's frame

    /// Points of the mount's frame in the laboratory, 3 x n [m].
    Eigen::Matrix3Xd in_laboratory(const Eigen::Matrix3Xd& X) const;
    /// Velocities in the laboratory of points at X that move by V in the mount's frame, 3 x n [m/s].
    Eigen::Matrix3Xd velocities_in_laboratory(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xd& V) const;
};

/// Rigid motion of the mount against the cameras. Immutable.
class MountMotion {
public:
    virtual ~MountMotion() = default;
    /// Pose at a time of the trial [s].
    virtual MountPose at(double time_s) const = 0;
    /// Whether the mount turns; otherwise its rotation is always the identity.
    virtual bool turns() const = 0;
};
using MountMotionPointer = std::shared_ptr<const MountMotion>;

/// Translation along a line, amplitude sin(2 pi frequency t + phase).
struct MountVibration {
    Eigen::Vector3d amplitude_m = Eigen::Vector3d::Zero();
    double frequency_Hz = 0.0;  // 0: a constant shift
    double phase_rad = 0.0;
};

/// A motion with vibrations added to it, along directions fixed in the laboratory.
///
/// @param motion      null: the mount does nothing else
/// @return            null without motion and vibrations; `motion` itself without vibrations
MountMotionPointer with_vibrations(MountMotionPointer motion, const std::vector<MountVibration>& vibrations);

/// A motion that was recorded by another clock: at time t the mount is where `motion` has it at rate (t - offset_s).
///
/// @param motion  may be null, as the result then is
MountMotionPointer by_clock(MountMotionPointer motion, double offset_s, double rate);

}  // namespace myo::model
