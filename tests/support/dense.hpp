#pragma once

#include <Eigen/Core>

// Textbook solutions for comparison in tests. Compiled once, as Eigen's decompositions compile slowly.

namespace myo::test {

/// The x that minimises
/// A x - b
/// , by QR.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// An orthonormal basis of the columns of A, by QR.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& A);

/// Inverse of a square matrix, by LU with full pivoting.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);

/// Numerical rank, by LU with full pivoting.
Eigen::Index rank(const Eigen::MatrixXd& A);

}  // namespace myo::test
