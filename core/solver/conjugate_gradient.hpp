#pragma once

#include <Eigen/Core>

#include <functional>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// A linear map of columns, n x k to n x k.
using LinearOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

struct ConjugateGradientReport {
    Eigen::MatrixXd solution;
    int iterations = 0;
    double relative_residual = 1.0;   // the largest of all columns
    bool negative_curvature = false;  // the operator is not positive definite; `solution` is the last iterate
    bool converged = false;
};

/// Preconditioned conjugate gradients for the columns of A X = B side by side, each its own iteration, so that they
/// share the passes over A and over the preconditioner. Starts from `guess`, or from 0 when it is empty.
///
/// Stops when |b - A x| <= tolerance |b| in every column, after `max_iterations`, or on a direction of negative
/// curvature. Source: Nocedal & Wright 2006, alg. 5.3 and 7.1.
ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner,
                                           const Eigen::MatrixXd& B, double tolerance, int max_iterations,
                                           const Eigen::MatrixXd& guess = {});

/// A X for a symmetric matrix stored as its lower triangle; one pass over A for all columns.
Eigen::MatrixXd symmetric_product(const SymmetricSparse& lower, const Eigen::MatrixXd& X);

}  // namespace myo::solver
