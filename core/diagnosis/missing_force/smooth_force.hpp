#pragma once

#include <Eigen/Core>

namespace myo::diagnosis {

/// Tikhonov's solutions x of |d + A x|^2 + lambda x' R x, for any lambda at once.
class SmoothForce {
public:
    /// @param R  symmetric and positive definite
    SmoothForce(const Eigen::MatrixXd& A, const Eigen::MatrixXd& R);

    /// With the largest lambda that keeps |d + A x|^2 at or below `squares`; where none does, nearly the least that can
    /// be had.
    Eigen::VectorXd solve(const Eigen::VectorXd& d, double squares) const;

private:
    Eigen::MatrixXd A_;
    Eigen::MatrixXd to_x_;  // from coordinates in which A'A is diagonal and R is 1
    Eigen::VectorXd diagonal_;
};

}  // namespace myo::diagnosis
