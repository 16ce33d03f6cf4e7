#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

/// A run of occluded samples, both ends included.
struct Gap {
    Eigen::Index first = 0;
    Eigen::Index last = 0;
};

/// What the cameras did not see of one marker.
struct MarkerGaps {
    std::string label;
    std::vector<Gap> gaps;
    Eigen::Index occluded_samples = 0;
    double occluded_fraction = 0.0;
};

/// The gaps of every marker, in the order of the labels.
std::vector<MarkerGaps> gap_map(const Recording& recording);

/// Whether sample t of a track was seen.
inline bool is_seen(const Eigen::Matrix3Xd& track, Eigen::Index t) { return track.col(t).allFinite(); }

/// Samples in which every marker is exactly where it was in the sample before, gaps included, and at least one was
/// seen: a polled stream that had nothing new to tell. They carry no information of their own time.
std::vector<Eigen::Index> repeated_samples(const Recording& recording);

}  // namespace myo::measurement
