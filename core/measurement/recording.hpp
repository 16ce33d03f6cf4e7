#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::measurement {

/// What a motion-capture file holds, in SI units and the camera frame.
///
/// tracks[i] is 3 x T [m] for labels[i]; an occluded sample is NaN in all three coordinates. time_s has T ascending
/// entries.
struct Recording {
    std::vector<std::string> labels;
    Eigen::VectorXd time_s;
    std::vector<Eigen::Matrix3Xd> tracks;
    double rate_Hz = 0.0;
    /// Reconstruction residual per label, T entries [m], NaN where occluded; empty when the file has none.
    std::vector<Eigen::VectorXd> residual_m;

    Eigen::Index sample_count() const { return time_s.size(); }
};

}  // namespace myo::measurement
