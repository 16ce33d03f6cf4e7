#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace myo::dynamics {

/// Stage solutions of a run, used as initial guesses by a run with a similar motion.
struct StagePath {
    std::vector<double> times_s;              // ascending
    std::vector<Eigen::Matrix3Xd> positions;  // 3 x n [m]

    /// Positions of the stage within 1e-6 `step_s` of the given time; null if there is none.
    const Eigen::Matrix3Xd* at(double time_s, double step_s) const {
        const double least = time_s - 1e-6 * step_s;
        const auto found = std::lower_bound(times_s.begin(), times_s.end(), least);
        if (found == times_s.end() || *found > time_s + 1e-6 * step_s) return nullptr;
        return &positions[static_cast<std::size_t>(found - times_s.begin())];
    }
};

}  // namespace myo::dynamics
