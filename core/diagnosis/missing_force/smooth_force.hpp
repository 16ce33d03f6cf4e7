#pragma once

#include <Eigen/Core>

#include "diagnosis/diagnosis_policy.hpp"

namespace myo::diagnosis {

/// Tikhonov solutions: x that minimises |d + A x|^2 + lambda x' R x, after one factorisation for all lambda.
class SmoothForce {
public:
    /// @param A  residuals x unknowns
    /// @param R  symmetric and positive definite
    SmoothForce(const Eigen::MatrixXd& A, const Eigen::MatrixXd& R, const MissingForcePolicy& policy);

    /// Solution with the largest lambda for which |d + A x|^2 is at most `squares`; if that is out of reach, nearly the
    /// smallest residual possible (MissingForcePolicy::reachable).
    Eigen::VectorXd solve(const Eigen::VectorXd& d, double squares) const;

private:
    MissingForcePolicy policy_;
    Eigen::MatrixXd A_;
    Eigen::MatrixXd to_x_;  // from coordinates in which A'A is diagonal and R the identity
    Eigen::VectorXd diagonal_;
};

}  // namespace myo::diagnosis
