#pragma once

#include <Eigen/Core>

// Textbook answers to which tests compare, compiled once.

namespace myo::test {

/// The x of the least |A x - b|, by QR.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// An orthonormal basis of the columns of A, by QR.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& A);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);

Eigen::Index rank(const Eigen::MatrixXd& A);

}  // namespace myo::test
