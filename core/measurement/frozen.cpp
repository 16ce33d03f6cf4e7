#include "measurement/frozen.hpp"

#include <algorithm>
#include <limits>

#include "measurement/gaps.hpp"
#include "measurement/noise.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Thresholds of find_frozen().
struct FrozenPolicy {
    Index min_repeats = 4;         // shorter runs are spikes or polled samples
    double min_motion = 10.0;      // over noise and rounding: certain beyond chance
    double finest_step_m = 1e-6;   // least rounding considered; no camera resolves less
    double min_noise_steps = 1.0;  // noise in rounding steps from which exact repetition is no chance
    double min_jump_ratio = 3.0;   // jump at the end over the step behind it: a body at rest accelerates gradually
};
constexpr FrozenPolicy frozen_policy;

/// Largest extent along an axis of the visible samples in [first, end), without those in [skip_first, skip_end).
double extent(const Eigen::Matrix3Xd& track, Index first, Index end, Index skip_first = 0, Index skip_end = 0) {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (Index t = first; t < end; ++t) {
        if (!is_seen(track, t) || (t >= skip_first && t < skip_end)) continue;
        low = low.cwiseMin(track.col(t));
        high = high.cwiseMax(track.col(t));
    }
    return low(0) <= high(0) ? (high - low).maxCoeff() : 0.0;
}

/// Tracks with the numbers that every interval needs.
struct FrozenSearch {
    const std::vector<Eigen::Matrix3Xd>& tracks;
    double step_m;                // rounding
    std::vector<double> noise_m;  // per track, at least the rounding
    std::vector<double> range_m;  // per track, over the whole recording

    FrozenSearch(const std::vector<Eigen::Matrix3Xd>& all, double rounding_m)
        : tracks(all), step_m(std::max(rounding_m, frozen_policy.finest_step_m)) {
        for (const Eigen::Matrix3Xd& track : tracks) {
            noise_m.push_back(std::max(estimate_track_noise(track).sigma_m, step_m));
            range_m.push_back(extent(track, 0, track.cols()));
        }
    }

    /// Whether the other markers move during an interval, and this one should.
    bool should_move(const FrozenInterval& at) const {
        std::size_t visible = 0;
        std::vector<double> shares;  // of the others' motion in their whole range
        for (std::size_t k = 0; k < tracks.size(); ++k) {
            if (k == at.marker || !is_seen(tracks[k], at.first)) continue;
            ++visible;
            const double moved_m = extent(tracks[k], at.first - 1, at.end);
            if (moved_m > frozen_policy.min_motion * noise_m[k]) shares.push_back(moved_m / range_m[k]);
        }
        if (shares.empty() || 2 * shares.size() < visible) return false;
        const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
        std::nth_element(shares.begin(), middle, shares.end());
        const double own_m = extent(tracks[at.marker], 0, tracks[at.marker].cols(), at.first, at.end);
        return own_m * *middle > frozen_policy.min_motion * step_m;
    }

    /// Noise of the other samples of the track, in rounding steps.
    double noise_steps(const FrozenInterval& at) const {
        Eigen::Matrix3Xd rest = tracks[at.marker];
        rest.middleCols(at.first, at.end - at.first).setConstant(std::numeric_limits<double>::quiet_NaN());
        return estimate_track_noise(rest).sigma_m / step_m;
    }

    bool ends_with_jump(const FrozenInterval& at) const {
        const Eigen::Matrix3Xd& track = tracks[at.marker];
        if (at.end + 1 >= track.cols() || !is_seen(track, at.end) || !is_seen(track, at.end + 1)) return false;
        const double jump_m = (track.col(at.end) - track.col(at.end - 1)).norm(),
                     next_m = (track.col(at.end + 1) - track.col(at.end)).norm();
        return jump_m > frozen_policy.min_jump_ratio * next_m + frozen_policy.min_motion * step_m;
    }
};

}  // namespace

std::vector<FrozenInterval> find_frozen(const std::vector<Eigen::Matrix3Xd>& tracks, double rounding_m) {
    const FrozenSearch search(tracks, rounding_m);
    std::vector<FrozenInterval> found;
    for (std::size_t m = 0; m < tracks.size(); ++m) {
        const Eigen::Matrix3Xd& track = tracks[m];
        for (Index t = 1; t < track.cols(); ++t) {
            FrozenInterval run{m, t, t};
            while (run.end < track.cols() && is_seen(track, run.end) && track.col(run.end) == track.col(t - 1))
                ++run.end;
            if (run.end - run.first >= frozen_policy.min_repeats && search.should_move(run) &&
                (search.noise_steps(run) >= frozen_policy.min_noise_steps || search.ends_with_jump(run)))
                found.push_back(run);
            t = std::max(t, run.end - 1);
        }
    }
    return found;
}

}  // namespace myo::measurement
