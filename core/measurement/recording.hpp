#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::measurement {

/// Motion-capture recording, in SI units and the camera frame.
struct Recording {
    std::vector<std::string> labels;       // of the markers
    Eigen::VectorXd time_s;                // T, ascending
    std::vector<Eigen::Matrix3Xd> tracks;  // per label, 3 x T [m]; an occluded sample is NaN in all coordinates
    double rate_Hz = 0.0;                  // nominal frame rate
    /// Reconstruction residual per label, T entries [m], NaN where occluded; empty if the file has none.
    std::vector<Eigen::VectorXd> residual_m;
    double metres_per_unit = 1.0;         // of the numbers in the file
    std::vector<std::string> warnings{};  // of reading the file, one sentence each

    /// T, occluded samples included.
    Eigen::Index sample_count() const { return time_s.size(); }
};

}  // namespace myo::measurement
