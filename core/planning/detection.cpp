#include "planning/detection.hpp"

#include <algorithm>

#include "statistics/distributions.hpp"

namespace myo::planning {

std::vector<ErrorBlock> error_blocks(const statistics::ResidualLayout& layout, Eigen::Index offset) {
    std::vector<ErrorBlock> blocks;
    int trial = -1;
    for (const statistics::ResidualSeries& series : layout.series) {
        // Series are ordered by trial: those of one trial are adjacent rows.
        if (blocks.empty() || series.trial != trial) blocks.push_back({offset + series.begin, 0});
        trial = series.trial;
        blocks.back().size = offset + series.end - blocks.back().begin;
    }
    return blocks;
}

double noncentrality(const Eigen::VectorXd& d, const std::vector<ErrorBlock>& blocks, double numerical_error) {
    const double squares = d.squaredNorm();
    if (!(squares > 0.0)) return 0.0;
    // In units of the noise, whose variance is 1. An error of rms e along the unit vector u has the length e sqrt(n).
    double variance = 1.0;
    for (const ErrorBlock& block : blocks)
        variance += numerical_error * numerical_error * static_cast<double>(block.size) *
                    d.segment(block.begin, block.size).squaredNorm() / squares;
    return squares / variance;
}

double detection_probability(double noncentrality, double freedom, double alpha) {
    return statistics::noncentral_chi_squared_tail(statistics::chi_squared_upper_quantile(alpha, freedom), freedom,
                                                   noncentrality);
}

double needed_noncentrality(double probability, double freedom, const DetectionPolicy& policy) {
    double low = 0.0, high = policy.most_noncentrality;
    // The probability grows with the noncentrality.
    for (int i = 0; i < policy.bisections; ++i) {
        const double middle = 0.5 * (low + high);
        (detection_probability(middle, freedom, policy.alpha) < probability ? low : high) = middle;
    }
    return high;
}

}  // namespace myo::planning
