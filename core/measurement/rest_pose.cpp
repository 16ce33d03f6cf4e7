#include "measurement/rest_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measurement/gaps.hpp"
#include "measurement/robust.hpp"

namespace myo::measurement {
namespace {

// Visible columns of `track` in [first, end).
Eigen::Matrix3Xd seen_samples(const Eigen::Matrix3Xd& track, Eigen::Index first, Eigen::Index end) {
    Eigen::Matrix3Xd seen(3, end - first);
    Eigen::Index count = 0;
    for (Eigen::Index t = first; t < end; ++t) {
        if (is_seen(track, t)) seen.col(count++) = track.col(t);
    }
    return seen.leftCols(count);
}

/// Samples within `deviations` robust standard deviations of the median in every coordinate.
Eigen::Matrix3Xd without_outliers(const Eigen::Matrix3Xd& samples, double deviations) {
    Eigen::Vector3d centre;
    Eigen::Vector3d reach;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::VectorXd values = samples.row(axis);
        centre(axis) = median(values);
        reach(axis) = deviations * median_deviation(values, centre(axis));
    }
    // A marker whose digits never change has zero deviation: leave room for rounding.
    reach.array() += 1e-12;
    Eigen::Matrix3Xd kept(3, samples.cols());
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < samples.cols(); ++k) {
        if (((samples.col(k) - centre).array().abs() <= reach.array()).all()) kept.col(count++) = samples.col(k);
    }
    // With few, coarsely rounded samples most may be outliers in some coordinate; then use all of them.
    return 2 * count > samples.cols() ? Eigen::Matrix3Xd(kept.leftCols(count)) : samples;
}

/// Standard deviation of a coordinate, pooled over the three coordinates.
double deviation(const Eigen::Matrix3Xd& kept, const Eigen::Vector3d& mean) {
    const double squares = (kept.colwise() - mean).squaredNorm();
    return std::sqrt(squares / (3.0 * static_cast<double>(kept.cols() - 1)));
}

}  // namespace

Result<RestPose> rest_pose(const Recording& recording, Eigen::Index start_sample, const RestPoseOptions& options) {
    const Eigen::Index end = std::min(start_sample, recording.sample_count());
    if (end < 1) return Error{"there is no sample before the start of the motion, so no rest pose", ""};
    Eigen::Index first = 0;
    // First sample of the averaging interval.
    while (first < end - 1 && recording.time_s(first) < recording.time_s(end - 1) - options.longest_s) ++first;
    const auto count = static_cast<Eigen::Index>(recording.labels.size());
    RestPose pose;
    pose.labels = recording.labels;
    pose.positions_m = Eigen::Matrix3Xd::Constant(3, count, std::numeric_limits<double>::quiet_NaN());
    pose.deviation_m = Eigen::VectorXd::Zero(count);
    pose.samples_used = Eigen::VectorXi::Zero(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto label = static_cast<std::size_t>(i);
        Eigen::Matrix3Xd samples = seen_samples(recording.tracks[label], first, end);
        // A marker hidden just before the start may have been visible earlier.
        if (samples.cols() == 0) samples = seen_samples(recording.tracks[label], 0, first);
        if (samples.cols() == 0) {
            pose.missing.push_back(recording.labels[label]);
            continue;
        }
        const Eigen::Matrix3Xd kept = without_outliers(samples, options.outlier_deviations);
        pose.positions_m.col(i) = kept.rowwise().mean();
        pose.samples_used(i) = static_cast<int>(kept.cols());
        if (kept.cols() > 1) pose.deviation_m(i) = deviation(kept, pose.positions_m.col(i));
    }
    if (pose.missing.size() == recording.labels.size())
        return Error{"no marker is seen before the start of the motion, so no rest pose", ""};
    return pose;
}

Result<RestPose> rest_pose_before(const Recording& recording, double start_s, const RestPoseOptions& options) {
    const auto begin = recording.time_s.begin();
    const auto before = std::lower_bound(begin, recording.time_s.end(), start_s) - begin;
    return rest_pose(recording, std::max<Eigen::Index>(before, 1), options);
}

}  // namespace myo::measurement
