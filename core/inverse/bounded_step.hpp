#pragma once

#include <Eigen/Core>

namespace myo::inverse {

/// The step x that minimises |r + A x|^2 within lower <= x <= upper (infinite bounds allowed).
///
/// @param A  N x n of few columns; one that is zero takes no step. Bounds contain 0.
/// Cyclic descent along the coordinates, which ends at the minimum of a convex function within a box: Bertsekas 1999,
/// Nonlinear programming, 2.7.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& A, const Eigen::VectorXd& r, const Eigen::VectorXd& lower,
                             const Eigen::VectorXd& upper);

}  // namespace myo::inverse
