#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

/// A run of occluded samples, first and last included.
struct Gap {
    Eigen::Index first = 0;
    Eigen::Index last = 0;
};

/// Occlusion of one marker.
struct MarkerGaps {
    std::string label;
    std::vector<Gap> gaps;
    Eigen::Index occluded_samples = 0;  // over all gaps
    double occluded_fraction = 0.0;     // of the samples of the recording, 0 ... 1
};

/// Gaps of every marker, in the order of the labels.
std::vector<MarkerGaps> gap_map(const Recording& recording);

/// Whether sample t of a track is visible (not NaN).
inline bool is_seen(const Eigen::Matrix3Xd& track, Eigen::Index t) { return track.col(t).allFinite(); }

/// Samples identical to their predecessor in every marker, gaps included, with at least one visible marker.
///
/// They come from a polled stream without new data and carry no information about their own time.
std::vector<Eigen::Index> repeated_samples(const Recording& recording);

}  // namespace myo::measurement
