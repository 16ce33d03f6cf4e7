#include "measurement/recorded_mount.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "measurement/registration.hpp"
#include "measurement/smoothing_spline.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

/// Pose of a mount that does not turn and whose pivot follows a spline.
model::MountPose slid(const Vector3d& pivot_m, const QuinticSpline& place, double time_s) {
    model::MountPose pose;
    pose.pivot_m = pivot_m;
    pose.place_m = place.at(time_s);
    pose.velocity_m_s = place.at(time_s, 1);
    pose.acceleration_m_s2 = place.at(time_s, 2);
    return pose;
}

class SplinedMount : public model::MountMotion {
public:
    SplinedMount(const Vector3d& pivot, QuinticSpline place, QuinticSpline turn)
        : pivot_m_(pivot), place_(std::move(place)), turn_(std::move(turn)) {}

    model::MountPose at(double time_s) const override {
        model::MountPose pose = slid(pivot_m_, place_, time_s);
        // The quaternion is the splined one over its length; derivatives of s = |s| q solved for those of q.
        const Vector4d s = turn_.at(time_s), ds = turn_.at(time_s, 1), dds = turn_.at(time_s, 2);
        const double n = s.norm();
        const Vector4d q = s / n;
        const double dn = q.dot(ds), ddn = (ds.squaredNorm() + s.dot(dds) - dn * dn) / n;
        const Vector4d dq = (ds - dn * q) / n, ddq = (dds - 2.0 * dn * dq - ddn * q) / n;
        const Quaterniond now(q);
        pose.rotation = now.toRotationMatrix();
        pose.spin_rad_s = 2.0 * (now.conjugate() * Quaterniond(dq)).vec();
        pose.spin_rate_rad_s2 = 2.0 * (now.conjugate() * Quaterniond(ddq)).vec();
        return pose;
    }
    bool turns() const override { return true; }

private:
    Vector3d pivot_m_;
    QuinticSpline place_, turn_;
};

/// A mount whose turns do not exceed their noise.
class SlidingMount : public model::MountMotion {
public:
    SlidingMount(const Vector3d& pivot, QuinticSpline place) : pivot_m_(pivot), place_(std::move(place)) {}

    model::MountPose at(double time_s) const override { return slid(pivot_m_, place_, time_s); }
    bool turns() const override { return false; }

private:
    Vector3d pivot_m_;
    QuinticSpline place_;
};

class StandingMount : public model::MountMotion {
public:
    StandingMount(const Vector3d& pivot, const RigidMotion& motion) {
        pose_.pivot_m = pivot;
        pose_.rotation = motion.rotation;
        pose_.place_m = motion.apply(pivot);
    }
    model::MountPose at(double) const override { return pose_; }
    bool turns() const override { return true; }

private:
    model::MountPose pose_;
};

/// Rigid motions in the samples that show enough markers.
struct MountPoses {
    std::vector<Index> samples;
    std::vector<Registration> poses;
};

MountPoses mount_poses(const Recording& seen, const Matrix3Xd& rest) {
    MountPoses result;
    for (Index t = 0; t < seen.sample_count(); ++t) {
        Matrix3Xd there = Matrix3Xd::Zero(3, rest.cols());
        VectorXd weights = VectorXd::Zero(rest.cols());
        for (Index m = 0; m < rest.cols(); ++m) {
            const Vector3d y = seen.tracks[static_cast<std::size_t>(m)].col(t);
            if (!y.allFinite()) continue;
            there.col(m) = y;
            weights(m) = 1.0;
        }
        if (weights.sum() < 3.0) continue;
        Result<Registration> fit = rigid_registration(rest, there, weights);
        if (!fit) continue;
        // Hidden markers have no residual.
        fit->residual_m = (fit->residual_m * weights.asDiagonal()).eval();
        result.samples.push_back(t);
        result.poses.push_back(std::move(*fit));
    }
    return result;
}

bool shows_marker(const Recording& seen, Index marker, Index t) {
    return seen.tracks[static_cast<std::size_t>(marker)].col(t).allFinite();
}

/// Places from which each marker is off by nothing on average, as a whole where the declared ones are.
Matrix3Xd true_places(const Recording& seen, const Matrix3Xd& rest, const MountPoses& found) {
    Matrix3Xd places = rest;
    for (Index m = 0; m < rest.cols(); ++m) {
        Vector3d sum = Vector3d::Zero();
        double count = 0.0;
        for (std::size_t k = 0; k < found.samples.size(); ++k) {
            if (!shows_marker(seen, m, found.samples[k])) continue;
            sum -= found.poses[k].motion.rotation.transpose() * found.poses[k].residual_m.col(m);
            count += 1.0;
        }
        if (count > 0.0) places.col(m) += sum / count;
    }
    const Result<Registration> back = rigid_registration(places, rest);
    return back ? back->motion.apply_all(places) : rest;
}

/// Variance per coordinate: three degrees of freedom per marker less six of the motion.
double marker_variance(const Recording& seen, const MountPoses& found) {
    double squares = 0.0, freedom = 0.0;
    for (std::size_t k = 0; k < found.samples.size(); ++k) {
        squares += found.poses[k].residual_m.squaredNorm();
        for (Index m = 0; m < found.poses[k].residual_m.cols(); ++m)
            if (shows_marker(seen, m, found.samples[k])) freedom += 3.0;
        freedom -= 6.0;
    }
    return freedom > 0.0 ? squares / freedom : 0.0;
}

/// Mean motion of the samples from `first` to before `end`.
RigidMotion mean_motion(const MountPoses& found, std::size_t first, std::size_t end, const Vector3d& pivot) {
    Vector4d turn = Vector4d::Zero();
    Vector3d place = Vector3d::Zero();
    for (std::size_t k = first; k < end; ++k) {
        Vector4d q = Quaterniond(found.poses[k].motion.rotation).coeffs();
        if (q.dot(turn) < 0.0) q = -q;
        turn += q;
        place += found.poses[k].motion.apply(pivot) / static_cast<double>(end - first);
    }
    const Matrix3d R = Quaterniond(turn.normalized()).toRotationMatrix();
    return {R, place - R * pivot};
}

/// Motion while the mount rests before t = 0; that of the first sample if none is before.
RigidMotion resting(const Recording& seen, const MountPoses& found, const Vector3d& pivot) {
    std::size_t end = 0;
    while (end < found.samples.size() && seen.time_s(found.samples[end]) < 0.0) ++end;
    if (end == 0) return mean_motion(found, 0, 1, pivot);
    const double from_s = seen.time_s(found.samples[end - 1]) - recorded_mount_policy.rest_s;
    std::size_t first = end - 1;
    while (first > 0 && seen.time_s(found.samples[first - 1]) >= from_s) --first;
    return mean_motion(found, first, end, pivot);
}

/// Variance of a quaternion of the rotation, summed over its components: a quarter of that of the rotation vector.
double turn_variance(const Matrix3Xd& rest, const Vector3d& pivot, double variance) {
    const Matrix3Xd r = rest.colwise() - pivot;
    const Matrix3d inertia = r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
    return 0.25 * variance * inertia.inverse().trace();
}

}  // namespace

Result<RecordedMount> recorded_mount(const Recording& seen, const Matrix3Xd& rest_m, bool from_rest) {
    MountPoses found = mount_poses(seen, rest_m);
    if (found.samples.empty())
        return Error{"three markers of the mount that are not in one line are never seen together", ""};
    const Matrix3Xd rest = true_places(seen, rest_m, found);
    found = mount_poses(seen, rest);
    const Vector3d pivot = rest.rowwise().mean();
    if (from_rest) {
        const RigidMotion back = resting(seen, found, pivot).inverse();
        for (Registration& pose : found.poses) pose.motion = compose(back, pose.motion);
    }
    RecordedMount result;
    const double variance = marker_variance(seen, found);
    result.noise_m = std::sqrt(variance);
    const auto count = static_cast<Index>(found.samples.size());
    VectorXd times(count);
    Matrix3Xd places(3, count);
    Eigen::Matrix4Xd turns(4, count);
    for (Index k = 0; k < count; ++k) {
        const auto s = static_cast<std::size_t>(k);
        times(k) = seen.time_s(found.samples[s]);
        places.col(k) = found.poses[s].motion.apply(pivot);
        turns.col(k) = Quaterniond(found.poses[s].motion.rotation).coeffs();
        // A quaternion and its negative are one rotation: the nearer continues the course.
        if (k > 0 && turns.col(k).dot(turns.col(k - 1)) < 0.0) turns.col(k) *= -1.0;
        if (k > 0) result.gap_s = std::max(result.gap_s, times(k) - times(k - 1));
    }
    if (count < recorded_mount_policy.least_samples) {
        result.motion = std::make_shared<StandingMount>(pivot, mean_motion(found, 0, found.samples.size(), pivot));
        return result;
    }
    // The vector part is half the rotation vector.
    const double of_turn = turn_variance(rest, pivot, variance),
                 turned = turns.topRows<3>().squaredNorm() / static_cast<double>(count);
    const double of_place = 3.0 * variance / static_cast<double>(rest.cols());
    QuinticSpline place = smoothing_spline(times, places, of_place);
    if (turned <= std::max(std::pow(recorded_mount_policy.turn_ratio, 2) * of_turn,
                           std::pow(0.5 * recorded_mount_policy.least_turn_rad, 2))) {
        result.motion = std::make_shared<SlidingMount>(pivot, std::move(place));
        return result;
    }
    result.motion = std::make_shared<SplinedMount>(pivot, std::move(place), smoothing_spline(times, turns, of_turn));
    return result;
}

}  // namespace myo::measurement
