#include "setup/hold_recording.hpp"

#include <cmath>
#include <limits>

namespace myo::setup {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Mean of the visible samples; NaN if there are none.
Vector3d mean_of(const Matrix3Xd& track) {
    Vector3d sum = Vector3d::Zero();
    double count = 0.0;
    for (const auto& sample : track.colwise())
        if (sample.allFinite()) {
            sum += sample;
            ++count;
        }
    return sum / count;
}

}  // namespace

measurement::Recording mean_pose(const measurement::Recording& recording) {
    measurement::Recording pose = recording;
    pose.time_s = VectorXd::Zero(1);
    for (Matrix3Xd& track : pose.tracks) track = mean_of(track).eval();
    pose.residual_m.clear();
    return pose;
}

VectorXd spread_of_pose(const measurement::Recording& recording) {
    VectorXd spread = VectorXd::Constant(static_cast<Index>(recording.tracks.size()),
                                         std::numeric_limits<double>::quiet_NaN());
    for (Index m = 0; m < spread.size(); ++m) {
        const Matrix3Xd& track = recording.tracks[static_cast<std::size_t>(m)];
        const Vector3d mean = mean_of(track);
        double squares = 0.0, count = 0.0;
        for (const auto& sample : track.colwise())
            if (sample.allFinite()) {
                squares += (sample - mean).squaredNorm();
                ++count;
            }
        // Three coordinates per sample, less one degree of freedom each for the mean.
        if (count > 1.0) spread(m) = std::sqrt(squares / (3.0 * (count - 1.0)));
    }
    return spread;
}

}  // namespace myo::setup
