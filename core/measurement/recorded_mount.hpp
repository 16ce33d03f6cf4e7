#pragma once

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "model/mount_motion.hpp"

namespace myo::measurement {

struct RecordedMountPolicy {
    /// Fewer samples are averaged to a mount at rest: a spline of degree five with its strength would not be
    /// determined.
    Eigen::Index least_samples = 12;
    /// A mount whose rotations have at most this ratio to their noise, rms over the samples, is taken not to turn: the
    /// rms of noise alone varies by a few percent.
    double turn_ratio = 1.2;
    double least_turn_rad = 1e-6;  // rms, likewise: rounding of recordings without noise
    double rest_s = 1.0;           // length of the rest before the start that is averaged, as in RestPoseOptions
};
inline constexpr RecordedMountPolicy recorded_mount_policy;

/// Motion of a mount that was seen by markers on it.
struct RecordedMount {
    model::MountMotionPointer motion;
    double noise_m = 0.0;  // standard deviation per coordinate of its markers, from their distances
    double gap_s = 0.0;    // longest time without three of its markers
};

/// Smooth rigid motion of the markers on a mount, with velocity and acceleration.
///
/// Per sample the rigid motion that brings the markers from rest to where they were seen, then smoothing_spline() of
/// their centre and of the quaternion of the rotation. The noise comes from the distances between the markers, which
/// are those of a rigid body. Places that are declared wrongly by a constant offset are corrected by their mean, so
/// that an occluded marker does not jerk the mount. Rotations within their noise are none. Before the first sample the
/// mount stands still.
///
/// @param seen       the markers on the mount alone [m]; times of the trial, t = 0 at the start [s]
/// @param rest_m     their declared places, 3 x markers, in the mesh frame
/// @param from_rest  motion against the mean place before t = 0, or in the first sample, instead of against the
///                   declared places: for recordings whose frame is not known
/// Errors: no sample with three markers that are not in one line.
Result<RecordedMount> recorded_mount(const Recording& seen, const Eigen::Matrix3Xd& rest_m, bool from_rest);

}  // namespace myo::measurement
