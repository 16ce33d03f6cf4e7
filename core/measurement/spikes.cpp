#include "measurement/spikes.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>

#include "measurement/gaps.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

struct SpikesPolicy {
    double min_deviations = 10.0;
    double min_ratio = 6.0;
    std::size_t longest_run = 3;
    /// Runs on each side that measure the usual deviation of a track from a cubic, and how many of them must exist.
    std::size_t nearby = 4;
    std::size_t min_nearby = 4;
    /// Missing samples among the points of a cubic: over a longer gap the cubic is not meaningful.
    Index max_missing = 3;
};
constexpr SpikesPolicy spikes_policy;

/// Visible samples of a track, without the spikes found so far.
class Seen {
public:
    Seen(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s) : track_(track), time_s_(time_s) {
        for (Index t = 0; t < track.cols(); ++t)
            if (is_seen(track, t)) samples_.push_back(t);
    }

    std::size_t count() const { return samples_.size(); }
    Index sample(std::size_t place) const { return samples_[place]; }
    void take_out(std::size_t first, std::size_t length) {
        samples_.erase(samples_.begin() + static_cast<std::ptrdiff_t>(first),
                       samples_.begin() + static_cast<std::ptrdiff_t>(first + length));
    }

    /// Distance of the sample at `place` from the cubic through the two samples before and the two after the run
    /// [first, first + length), which contains it. nullopt at the ends and next to gaps.
    std::optional<double> distance(std::size_t place, std::size_t first, std::size_t length) const {
        if (first < 2 || first + length + 2 > count()) return std::nullopt;
        const Index points[4] = {samples_[first - 2], samples_[first - 1], samples_[first + length],
                                 samples_[first + length + 1]};
        if (points[3] - points[0] > static_cast<Index>(length) + 3 + spikes_policy.max_missing) return std::nullopt;
        const Index at = samples_[place];
        Vector3d cubic = Vector3d::Zero();
        for (int i = 0; i < 4; ++i) {
            double weight = 1.0;  // Lagrange weight
            for (int j = 0; j < 4; ++j)
                if (j != i) weight *= (time_s_(at) - time_s_(points[j])) / (time_s_(points[i]) - time_s_(points[j]));
            cubic += weight * track_.col(points[i]);
        }
        return (track_.col(at) - cubic).norm();
    }

    /// Smallest and largest distance of the samples of a run; nullopt if one of them is unknown.
    struct Range {
        double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    };
    std::optional<Range> distances(std::size_t first, std::size_t length) const {
        Range range;
        for (std::size_t place = first; place < first + length; ++place) {
            const std::optional<double> one = distance(place, first, length);
            if (!one) return std::nullopt;
            range.least = std::min(range.least, *one);
            range.largest = std::max(range.largest, *one);
        }
        return range;
    }

    /// Largest deviation of runs of this length near `place` from their own neighbours; nullopt if too few are known.
    std::optional<double> unrest_around(std::size_t place, std::size_t length) const {
        double largest = 0.0;
        std::size_t told = 0;
        const std::size_t before = spikes_policy.nearby + length - 1;
        for (std::size_t first = place - std::min(before, place);
             first < std::min(place + spikes_policy.nearby, count()); ++first)
            if (const std::optional<Range> run = distances(first, length)) {
                largest = std::max(largest, run->largest);
                ++told;
            }
        return told >= spikes_policy.min_nearby ? std::optional(largest) : std::nullopt;
    }

private:
    const Eigen::Matrix3Xd& track_;
    const Eigen::VectorXd& time_s_;
    std::vector<Index> samples_;
};

}  // namespace

Spikes find_spikes(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s, double sigma_m) {
    assert(track.cols() == time_s.size());
    Spikes spikes;
    Seen seen(track, time_s);
    // Short runs first: a single outlier must not make its neighbours part of a longer run.
    for (std::size_t length = 1; length <= spikes_policy.longest_run; ++length)
        for (std::size_t first = 2; first + length + 2 <= seen.count(); ++first) {
            // Every sample of the run must deviate, hence the least distance.
            const auto out = seen.distances(first, length);
            if (!out || !(out->least > spikes_policy.min_deviations * sigma_m)) continue;
            // Usual deviation without the run, which would otherwise raise it.
            Seen without = seen;
            without.take_out(first, length);
            const std::optional<double> unrest = without.unrest_around(first, length);
            if (!unrest || !(out->least > spikes_policy.min_ratio * *unrest)) continue;
            for (std::size_t place = first; place < first + length; ++place)
                spikes.samples.push_back(seen.sample(place));
            spikes.largest_m = std::max(spikes.largest_m, out->largest);
            seen.take_out(first, length);
        }
    std::sort(spikes.samples.begin(), spikes.samples.end());
    return spikes;
}

}  // namespace myo::measurement
