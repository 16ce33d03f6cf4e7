#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include "diagnosis/distributions.hpp"
#include "diagnosis/residual_tests.hpp"

namespace myo {
namespace {

// Of the largest eigenvalue of a real Wishart matrix (Tracy-Widom law of order 1).
constexpr double tracy_widom_skewness = 0.2935;

// The smaller of the two products with the transpose; its eigenvalues are the squared singular values.
Eigen::MatrixXd gram(const Eigen::MatrixXd& values) {
    return values.rows() <= values.cols() ? Eigen::MatrixXd(values * values.transpose()) : Eigen::MatrixXd(values.transpose() * values);
}

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()(symmetric.rows() - 1);
}

// std::bernoulli_distribution differs between libraries; bits do not.
void flip_signs(Eigen::MatrixXd& values, std::mt19937_64& random) {
    std::uint64_t bits = 0;
    int left = 0;
    for (double& value : values.reshaped()) {
        if (left == 0) {
            bits = random();
            left = 64;
        }
        if (bits & 1U) value = -value;
        bits >>= 1U;
        --left;
    }
}

// Left singular vector of the largest singular value, its largest entry positive.
Eigen::VectorXd first_pattern(const Eigen::MatrixXd& values) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram(values));
    Eigen::VectorXd pattern = eigen.eigenvectors().rightCols(1);
    if (pattern.size() != values.rows()) pattern = (values * pattern).normalized();
    Eigen::Index largest = 0;
    pattern.cwiseAbs().maxCoeff(&largest);
    return pattern(largest) < 0.0 ? Eigen::VectorXd(-pattern) : pattern;
}

SpaceTest::Trial test_trial(const GriddedTrial& grid, int draws, std::mt19937_64& random) {
    SpaceTest::Trial test;
    test.trial = grid.trial;
    test.series = grid.series;
    const double energy = grid.values.squaredNorm();
    test.pattern = Eigen::VectorXd::Zero(grid.values.rows());
    if (!(energy > 0.0)) return test;
    test.share = largest_eigenvalue(gram(grid.values)) / energy;
    test.pattern = first_pattern(grid.values);

    Eigen::ArrayXd shares(draws);
    Eigen::MatrixXd flipped = grid.values;
    for (double& share : shares) {
        flip_signs(flipped, random);
        share = largest_eigenvalue(gram(flipped)) / energy;
    }
    test.expected_share = shares.mean();
    const double deviation = std::sqrt((shares - shares.mean()).square().sum() / (draws - 1));
    // One series alone has no space: its share is 1, flipped or not, up to rounding.
    if (deviation > 1e-12) test.p = shifted_gamma_tail(test.share, test.expected_share, deviation, tracy_widom_skewness);
    return test;
}

}  // namespace

SpaceTest space_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws, unsigned seed) {
    assert(r.size() == layout.size() && draws > 1);
    SpaceTest test;
    std::mt19937_64 random(seed);
    for (const int trial : trials_of(layout)) {
        const GriddedTrial grid = gridded_trial(r, layout, trial);
        if (grid.series.empty()) continue;
        test.trials.push_back(test_trial(grid, draws, random));
        test.p = std::min(test.p, test.trials.back().p);
    }
    test.p = std::min(1.0, test.p * static_cast<double>(test.trials.size()));
    return test;
}

}  // namespace myo
