#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// One spatial pattern times one time course.
struct ResidualMode {
    double share = 0.0;  // of the trial's energy
    // 3 x markers, root mean square 1 over the series, sign such that the largest entry is positive
    Eigen::Matrix3Xd pattern;
    Eigen::VectorXd course;  // T: amplitude in units of the noise
};

/// Leading modes of one trial.
struct ResidualPatterns {
    int trial = 0;
    std::vector<int> markers;         // marker of each pattern column
    Eigen::VectorXd time_s;           // T
    std::vector<ResidualMode> modes;  // by decreasing share
};

/// Singular modes of the residual of each trial, for reports. Unseen samples count as zero.
/// @param r      N, see ResidualLayout
/// @param modes  upper limit per trial
std::vector<ResidualPatterns> residual_patterns(const Eigen::VectorXd& r, const ResidualLayout& layout, int modes = 3);

}  // namespace myo::statistics
