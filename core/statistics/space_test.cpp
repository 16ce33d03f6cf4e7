#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/decompositions.hpp"
#include "statistics/distributions.hpp"
#include "statistics/random_signs.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::statistics {
namespace {

struct SpaceTestConstants {
    /// Skewness of the largest eigenvalue of a real Wishart matrix (Tracy-Widom law of order 1).
    double tracy_widom_skewness = 0.2935;
};
constexpr SpaceTestConstants space_test_constants;

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
    return symmetric_eigenvalues(symmetric)(symmetric.rows() - 1);
}

// Left singular vector of the largest singular value, sign such that its largest entry is positive.
Eigen::VectorXd first_pattern(const Eigen::MatrixXd& values) {
    const Eigen::VectorXd pattern = leading_svd(values, 1).left.col(0);
    Eigen::Index largest = 0;
    pattern.cwiseAbs().maxCoeff(&largest);
    return pattern(largest) < 0.0 ? Eigen::VectorXd(-pattern) : pattern;
}

SpaceTest::Trial test_trial(const GriddedTrial& grid, int draws, RandomSigns& random) {
    SpaceTest::Trial test;
    test.trial = grid.trial;
    test.series = grid.series;
    const double energy = grid.values.squaredNorm();
    test.pattern = Eigen::VectorXd::Zero(grid.values.rows());
    if (!(energy > 0.0)) return test;
    test.share = largest_eigenvalue(smaller_gram(grid.values)) / energy;
    test.pattern = first_pattern(grid.values);

    Eigen::ArrayXd shares(draws);
    Eigen::MatrixXd flipped = grid.values;
    for (double& share : shares) {
        random.flip(flipped.reshaped());
        share = largest_eigenvalue(smaller_gram(flipped)) / energy;
    }
    test.expected_share = shares.mean();
    const double deviation = std::sqrt((shares - shares.mean()).square().sum() / (draws - 1));
    // A single series has share 1 with or without flips, up to rounding: no test possible.
    if (deviation > 1e-12) {
        // If few series carry most of the energy, the skewness exceeds its limit for large matrices.
        const double skewness = std::clamp((shares - shares.mean()).cube().mean() / std::pow(deviation, 3),
                                           space_test_constants.tracy_widom_skewness, 2.0);
        test.p = shifted_gamma_tail(test.share, test.expected_share, deviation, skewness);
    }
    return test;
}

}  // namespace

SpaceTest space_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws, unsigned seed) {
    assert(r.size() == layout.size() && draws > 1);
    SpaceTest test;
    RandomSigns random(seed);
    for (const int trial : trials_of(layout)) {
        const GriddedTrial grid = gridded_trial(r, layout, trial);
        if (grid.series.empty()) continue;
        test.trials.push_back(test_trial(grid, draws, random));
        test.p = std::min(test.p, test.trials.back().p);
    }
    if (!test.trials.empty()) test.p = std::min(1.0, test.p * static_cast<double>(test.trials.size()));
    return test;
}

}  // namespace myo::statistics
