#include "diagnosis/fit/repeatability.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Position of a track at a time, linear between two samples [m]; NaN outside the recording or next to an unseen one.
Vector3d at_time(const VectorXd& time_s, const Eigen::Matrix3Xd& track, double t_s) {
    const Index next = std::lower_bound(time_s.begin(), time_s.end(), t_s) - time_s.begin();
    if (next == time_s.size() || (next == 0 && time_s(0) > t_s))
        return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    if (next == 0 || time_s(next) == t_s) return track.col(next);
    const double share = (t_s - time_s(next - 1)) / (time_s(next) - time_s(next - 1));
    return (1.0 - share) * track.col(next - 1) + share * track.col(next);
}

/// Samples of two trials at the same times: differences, and what a shift in time or a rigid displacement would change.
struct Pairs {
    std::vector<Index> marker;  // per row of three entries
    std::vector<Vector3d> difference, velocity, position;
    double largest_model_m = 0.0;  // difference of the predictions
};

/// Pairs at the samples of `a` at which both trials are measured; `b` is interpolated there. Residuals, not positions,
/// are compared: small differences of the commanded motion are in the predictions and drop out.
Pairs pairs_of(const setup::PreparedTrial& a, const prediction::TrialPrediction& of_a, const setup::PreparedTrial& b,
               const prediction::TrialPrediction& of_b) {
    Pairs pairs;
    const VectorXd& time_s = a.measured.time_s;
    for (std::size_t m = 0; m < of_a.residual_m.size(); ++m)
        for (Index i = 0; i < time_s.size(); ++i) {
            const Vector3d here = of_a.residual_m[m].col(i);
            const Vector3d there = at_time(b.measured.time_s, of_b.residual_m[m], time_s(i));
            if (!here.allFinite() || !there.allFinite()) continue;
            const Eigen::Matrix3Xd& motion = of_a.positions_m[m];
            const Vector3d other = at_time(b.measured.time_s, of_b.positions_m[m], time_s(i));
            pairs.largest_model_m = std::max(pairs.largest_model_m, (other - motion.col(i)).norm());
            // Velocity of the predicted motion by a central difference, one-sided at the ends.
            const Index before = std::max<Index>(0, i - 1), after = std::min(i + 1, time_s.size() - 1);
            const double span_s = time_s(after) - time_s(before);
            pairs.velocity.push_back(span_s > 0.0 ? Vector3d((motion.col(after) - motion.col(before)) / span_s)
                                                  : Vector3d(Vector3d::Zero()));
            pairs.marker.push_back(static_cast<Index>(m));
            pairs.difference.push_back(here - there);
            pairs.position.push_back(motion.col(i));
        }
    return pairs;
}

/// Columns of a shift in time, and of a rigid displacement about the mean position.
/// To first order d = velocity * shift + translation + rotation x (position - mean).
MatrixXd alignment(const Pairs& pairs, bool rigid) {
    const auto n = static_cast<Index>(pairs.difference.size());
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& position : pairs.position) mean += position / static_cast<double>(n);
    MatrixXd columns = MatrixXd::Zero(3 * n, rigid ? 7 : 1);
    for (Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        columns.col(0).segment<3>(3 * i) = pairs.velocity[k];
        for (int axis = 0; axis < 3 && rigid; ++axis) {
            columns.col(1 + axis).segment<3>(3 * i) = Vector3d::Unit(axis);
            columns.col(4 + axis).segment<3>(3 * i) = Vector3d::Unit(axis).cross(pairs.position[k] - mean);
        }
    }
    return columns;
}

/// Differences of a pair of trials after the alignment, 3 per row of `pairs`; empty if they are no repeats.
std::optional<VectorXd> aligned_differences(const Pairs& pairs, bool rigid, double noise_m,
                                            const RepeatPolicy& policy) {
    const auto n = static_cast<Index>(pairs.difference.size());
    if (n < policy.min_samples || pairs.largest_model_m > policy.same_motion * noise_m) return {};
    VectorXd d(3 * n);
    for (Index i = 0; i < n; ++i) d.segment<3>(3 * i) = pairs.difference[static_cast<std::size_t>(i)];
    const MatrixXd columns = alignment(pairs, rigid);
    // A least-norm solution: a body at rest has no velocity, and markers on a line do not see one rotation.
    return d - columns * Eigen::CompleteOrthogonalDecomposition<MatrixXd>(columns).solve(d);
}

}  // namespace

Repeatability repeatability(const setup::Setup& setup, const std::vector<prediction::TrialPrediction>& predictions,
                            const RepeatPolicy& policy) {
    Repeatability result;
    const auto markers = static_cast<Index>(setup.marker_names.size());
    VectorXd squares = VectorXd::Zero(markers), count = VectorXd::Zero(markers);
    // Unless the registration is known, an error of it may displace one recording against the other.
    const bool rigid = !setup.experiment.registration.known;
    for (std::size_t a = 0; a < predictions.size(); ++a)
        for (std::size_t b = a + 1; b < predictions.size(); ++b) {
            const setup::PreparedTrial &first = setup.trials[a], &second = setup.trials[b];
            if (!predictions[a].ok() || !predictions[b].ok() || first.hold != second.hold) continue;
            // Unknown levels: equal predictions say nothing.
            if (!first.free_levels.empty() || !second.free_levels.empty()) continue;
            const Pairs pairs = pairs_of(first, predictions[a], second, predictions[b]);
            const std::optional<VectorXd> d = aligned_differences(pairs, rigid, setup::mean_noise(setup), policy);
            if (!d) continue;
            result.repeats.emplace_back(a, b);
            for (std::size_t i = 0; i < pairs.marker.size(); ++i) {
                // Half: the difference of two independent recordings has twice the variance of one.
                squares(pairs.marker[i]) += d->segment<3>(3 * static_cast<Index>(i)).squaredNorm() / 2.0;
                count(pairs.marker[i]) += 3.0;
            }
        }
    result.marker_rms_m = squares.cwiseQuotient(count).cwiseSqrt();
    if (result.known()) result.rms_m = std::sqrt(squares.sum() / count.sum());
    return result;
}

}  // namespace myo::diagnosis
