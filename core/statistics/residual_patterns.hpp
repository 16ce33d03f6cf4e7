#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// One pattern over the markers times one course over time.
struct ResidualMode {
    double share = 0.0;        // of the trial's energy
    Eigen::Matrix3Xd pattern;  // 3 x markers, root mean square 1 over the series; largest entry positive
    Eigen::VectorXd course;    // T, in units of the noise
};

struct ResidualPatterns {
    int trial = 0;
    std::vector<int> markers;         // columns of the patterns
    Eigen::VectorXd time_s;           // T
    std::vector<ResidualMode> modes;  // largest share first
};

/// Singular modes of the residual of each trial, for reports. Samples that were not seen count as zero.
std::vector<ResidualPatterns> residual_patterns(const Eigen::VectorXd& r, const ResidualLayout& layout, int modes = 3);

}  // namespace myo::statistics
