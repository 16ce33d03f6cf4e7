#include "measurement/gaps.hpp"

#include <algorithm>

namespace myo::measurement {

std::vector<MarkerGaps> gap_map(const Recording& recording) {
    std::vector<MarkerGaps> result;
    for (std::size_t i = 0; i < recording.labels.size(); ++i) {
        MarkerGaps marker;
        marker.label = recording.labels[i];
        for (Eigen::Index t = 0; t < recording.sample_count(); ++t) {
            if (is_seen(recording.tracks[i], t)) continue;
            ++marker.occluded_samples;
            // Extend the current gap or open a new one.
            if (!marker.gaps.empty() && marker.gaps.back().last == t - 1)
                marker.gaps.back().last = t;
            else
                marker.gaps.push_back({t, t});
        }
        const auto count = static_cast<double>(std::max<Eigen::Index>(recording.sample_count(), 1));
        marker.occluded_fraction = static_cast<double>(marker.occluded_samples) / count;
        result.push_back(std::move(marker));
    }
    return result;
}

std::vector<Eigen::Index> repeated_samples(const Recording& recording) {
    std::vector<Eigen::Index> repeats;
    for (Eigen::Index t = 1; t < recording.sample_count(); ++t) {
        bool any_seen = false;
        // A marker that stays hidden counts as unchanged; one that appears or disappears is new data.
        const bool same = std::all_of(recording.tracks.begin(), recording.tracks.end(),
                                      [&](const Eigen::Matrix3Xd& track) {
                                          const bool seen = is_seen(track, t);
                                          if (seen != is_seen(track, t - 1)) return false;
                                          any_seen = any_seen || seen;
                                          return !seen || track.col(t) == track.col(t - 1);
                                      });
        if (same && any_seen) repeats.push_back(t);
    }
    return repeats;
}

}  // namespace myo::measurement
