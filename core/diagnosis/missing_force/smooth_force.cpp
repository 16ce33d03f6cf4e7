#include "diagnosis/missing_force/smooth_force.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/decompositions.hpp"

namespace myo::diagnosis {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SmoothForce::SmoothForce(const MatrixXd& A, const MatrixXd& R, const MissingForcePolicy& policy)
    : policy_(policy), A_(A) {
    assert(A.cols() == R.cols());
    const Eigen::LLT<MatrixXd> factor(R);
    const MatrixXd squares = A.transpose() * A;
    const MatrixXd half = factor.matrixL().solve(squares);
    const MatrixXd whitened = factor.matrixL().solve(half.transpose());
    // With R = LL' and y = L'x the problem is that of L^-1 A'A L^-T, which one eigendecomposition makes diagonal.
    const SymmetricEigen modes = symmetric_eigen(whitened);
    diagonal_ = modes.values.cwiseMax(0.0);
    to_x_ = factor.matrixU().solve(modes.vectors);
}

VectorXd SmoothForce::solve(const VectorXd& d, double squares) const {
    const VectorXd g = to_x_.transpose() * (A_.transpose() * d);
    const double largest = diagonal_.maxCoeff();
    if (!(largest > 0.0)) return VectorXd::Zero(A_.cols());
    // |d + A x|^2 for the solution with lambda, from diagonal sums alone: no run of the bisection touches A.
    const auto left = [&](double lambda) {
        const Eigen::ArrayXd sum = diagonal_.array() + lambda;
        return d.squaredNorm() - (g.array().square() * (sum + lambda) / sum.square()).sum();
    };
    double low = std::log(policy_.lowest_lambda * largest), high = std::log(policy_.highest_lambda * largest);
    const double wanted = std::max(squares, policy_.reachable * left(std::exp(low)));
    for (int i = 0; i < policy_.bisections; ++i) {
        const double middle = 0.5 * (low + high);
        // The residual grows with lambda: bisection of its logarithm keeps left(low) within the target.
        (left(std::exp(middle)) <= wanted ? low : high) = middle;
    }
    return -(to_x_ * (g.array() / (diagonal_.array() + std::exp(low))).matrix());
}

}  // namespace myo::diagnosis
