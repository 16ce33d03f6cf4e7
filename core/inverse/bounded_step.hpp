#pragma once

#include <Eigen/Core>

namespace myo::inverse {

/// Bounded linear least squares: x that minimises |r + A x|^2 with lower <= x <= upper (infinite bounds allowed).
///
/// Cyclic coordinate descent, which converges to the minimum of a convex function within a box: Bertsekas 1999,
/// Nonlinear programming, 2.7.
/// @param A             N x n with few columns; the component of a zero column is 0
/// @param lower, upper  n; must contain 0
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& A, const Eigen::VectorXd& r, const Eigen::VectorXd& lower,
                             const Eigen::VectorXd& upper);

}  // namespace myo::inverse
