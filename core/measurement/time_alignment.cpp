#include "measurement/time_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

struct TimeAlignmentPolicy {
    Index max_samples = 600;  // of the resampled record: sufficient for a tenth of a sample with the parabola
};
constexpr TimeAlignmentPolicy time_alignment_policy;

/// Linear interpolation; NaN outside the samples, except the first value before them if `rests_before`.
Eigen::RowVectorXd resampled(const Eigen::VectorXd& time_s, const Eigen::RowVectorXd& values,
                             const Eigen::VectorXd& at_s, bool rests_before) {
    Eigen::RowVectorXd result = Eigen::RowVectorXd::Constant(at_s.size(), std::numeric_limits<double>::quiet_NaN());
    Index k = 0;
    for (Index i = 0; i < at_s.size(); ++i) {
        const double t = at_s[i];
        if (t < time_s[0]) {
            if (rests_before) result[i] = values[0];
            continue;
        }
        if (t > time_s[time_s.size() - 1]) break;
        // at_s ascends: the interval index only moves forward.
        while (k + 2 < time_s.size() && time_s[k + 1] < t) ++k;
        const double w = (t - time_s[k]) / (time_s[k + 1] - time_s[k]);
        result[i] = (1.0 - w) * values[k] + w * values[k + 1];
    }
    return result;
}

/// Correlation coefficient pooled over the coordinates, each about its mean over the shared samples; NaN if less than a
/// third of the samples are shared or nothing moves.
double correlation(const std::vector<Eigen::RowVectorXd>& a, const std::vector<Eigen::RowVectorXd>& b) {
    double ab = 0.0, aa = 0.0, bb = 0.0;
    Index shared = 0, all = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        double sum_a = 0.0, sum_b = 0.0, sum_ab = 0.0, sum_aa = 0.0, sum_bb = 0.0;
        Index n = 0;
        for (Index i = 0; i < a[c].size(); ++i) {
            const double x = a[c][i], y = b[c][i];
            // `all` counts what the record has, `shared` what both have.
            if (std::isnan(y)) continue;
            ++all;
            if (std::isnan(x)) continue;
            ++n;
            sum_a += x, sum_b += y, sum_ab += x * y, sum_aa += x * x, sum_bb += y * y;
        }
        if (n < 2) continue;
        const double count = static_cast<double>(n);
        shared += n;
        ab += sum_ab - sum_a * sum_b / count;
        aa += sum_aa - sum_a * sum_a / count;
        bb += sum_bb - sum_b * sum_b / count;
    }
    if (3 * shared < all || !(aa > 0.0) || !(bb > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return ab / std::sqrt(aa * bb);
}

/// All coordinates of the tracks on a grid of times.
std::vector<Eigen::RowVectorXd> on_grid(const Eigen::VectorXd& time_s, const std::vector<Matrix3Xd>& tracks,
                                        const Eigen::VectorXd& grid, bool holds_ends) {
    std::vector<Eigen::RowVectorXd> rows;
    for (const Matrix3Xd& track : tracks)
        for (int axis = 0; axis < 3; ++axis) rows.push_back(resampled(time_s, track.row(axis), grid, holds_ends));
    return rows;
}

/// Vertex of the parabola through the best score and its neighbours, in steps from the best.
double vertex_offset(const Eigen::VectorXd& scores, Index best) {
    const Index count = scores.size();
    double shift = 0.0;
    if (best > 0 && best + 1 < count && !std::isnan(scores[best - 1]) && !std::isnan(scores[best + 1])) {
        const double bend = scores[best - 1] - 2.0 * scores[best] + scores[best + 1];
        if (bend < 0.0) shift = 0.5 * (scores[best - 1] - scores[best + 1]) / bend;
    }
    return shift;
}

}  // namespace

Result<TimeAlignment> align_in_time(const Eigen::VectorXd& reference_time_s, const std::vector<Matrix3Xd>& reference,
                                    const Eigen::VectorXd& record_time_s, const std::vector<Matrix3Xd>& record) {
    if (reference.size() != record.size() || reference.empty())
        return Error{"both records must have the same markers", ""};
    if (reference_time_s.size() < 8 || record_time_s.size() < 8) return Error{"too few samples to align", ""};
    const double first = record_time_s[0], last = record_time_s[record_time_s.size() - 1];
    const double length = last - first, step = std::max(length / static_cast<double>(time_alignment_policy.max_samples),
                                                        length / static_cast<double>(record_time_s.size() - 1));
    const auto count = static_cast<Index>(std::floor(length / step + 1e-9)) + 1;
    const Eigen::VectorXd grid = Eigen::VectorXd::LinSpaced(count, first,
                                                            first + step * static_cast<double>(count - 1));
    const std::vector<Eigen::RowVectorXd> seen = on_grid(record_time_s, record, grid, false);
    // Exhaustive search: time 0 of the reference may lie anywhere in the record.
    Eigen::VectorXd scores(count);
    const auto score = [&](double delay) {
        return correlation(on_grid(reference_time_s, reference, grid.array() - delay, true), seen);
    };
    const double earliest = first - reference_time_s[0];
    Index best = -1;
    for (Index i = 0; i < count; ++i) {
        scores[i] = score(earliest + step * static_cast<double>(i));
        if (!std::isnan(scores[i]) && (best < 0 || scores[i] > scores[best])) best = i;
    }
    if (best < 0) return Error{"nothing moves in one of the records", ""};
    const double shift = vertex_offset(scores, best);
    return TimeAlignment{earliest + step * (static_cast<double>(best) + shift), scores[best]};
}

}  // namespace myo::measurement
