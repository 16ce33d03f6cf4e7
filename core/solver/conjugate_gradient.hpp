#pragma once

#include <Eigen/Core>

#include <functional>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// Linear map applied to each column of an n x k matrix; result n x k.
using LinearOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// Result of conjugate_gradient().
struct ConjugateGradientReport {
    Eigen::MatrixXd solution;         // n x k
    int iterations = 0;               // products with A, the same for all columns
    double relative_residual = 1.0;   // max over columns of |b - A x| / |b|, from the recursive residual
    bool negative_curvature = false;  // p'Ap <= 0 was met: A is not positive definite; `solution` is the last iterate
    bool converged = false;           // every column reached the tolerance
};

/// Preconditioned conjugate gradients for A X = B with several right-hand sides.
///
/// Each column is an independent iteration; the columns advance together and share the products with A and with the
/// preconditioner.
/// @param A, preconditioner  symmetric positive definite maps; the preconditioner approximates A^-1
/// @param B          right-hand sides, n x k
/// @param tolerance  stop when |b - A x| <= tolerance |b| in every column
/// @param guess      initial X, n x k; zero if empty
/// Errors: none; the report distinguishes convergence, iteration limit and negative curvature.
/// Source: Nocedal & Wright 2006, alg. 5.3 and 7.1.
ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner,
                                           const Eigen::MatrixXd& B, double tolerance, int max_iterations,
                                           const Eigen::MatrixXd& guess = {});

/// Product A X with a symmetric matrix stored as its lower triangle, X of n x k.
///
/// Up to 16 columns share one pass over A: the product is bound by memory bandwidth.
Eigen::MatrixXd symmetric_product(const SymmetricSparse& lower, const Eigen::MatrixXd& X);

}  // namespace myo::solver
