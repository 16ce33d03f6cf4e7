#pragma once

#include <Eigen/Core>

#include <functional>

namespace myo {

using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct ConjugateGradientReport {
    Eigen::VectorXd solution;
    int iterations = 0;
    double relative_residual = 1.0;
    bool negative_curvature = false;   // the operator is not positive definite; `solution` is the last iterate
    bool converged = false;
};

/// Preconditioned conjugate gradients for A x = b from x = 0.
///
/// Stops at |b - A x| <= tolerance |b|, after `max_iterations`, or on a direction of negative curvature.
/// Source: Nocedal & Wright 2006, alg. 5.3 and 7.1.
ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner, const Eigen::VectorXd& b,
                                           double tolerance, int max_iterations);

}  // namespace myo
