#pragma once

#include "inverse/least_squares.hpp"

namespace myo::inverse {

/// Jacobian at the points of a fit, recomputed only where the last one does not predict the residuals.
///
/// Along a displacement s the residuals change by J s + s'Hs/2 and the Jacobian by Hs. If the last Jacobian misses a
/// fraction of the change of the residuals, its own relative error at the end is twice that fraction.
/// Source: Madsen, Nielsen & Tingleff 2004, Methods for non-linear least squares problems, 3.4.
class ReusedJacobian {
public:
    /// Keeps references to all arguments. `jacobian` may be empty: the evaluations then contain their Jacobians.
    ReusedJacobian(const std::vector<Parameter>& parameters, const JacobianFunction& jacobian,
                   const LeastSquaresOptions& options, const Progress& progress, LeastSquaresReport& report);

    /// Jacobian at `values`, m x n. Empty if the model could not be run for the derivatives. After cancellation the
    /// last Jacobian is returned.
    /// @param there  evaluation at `values`
    Eigen::MatrixXd at(const Eigen::VectorXd& values, const ResidualEvaluation& there);

private:
    bool foretells(const Eigen::VectorXd& internal, const Eigen::VectorXd& residuals) const;
    Eigen::VectorXd internal(const Eigen::VectorXd& values) const;

    const std::vector<Parameter>& parameters_;
    const JacobianFunction& jacobian_;
    const LeastSquaresOptions& options_;
    const Progress& progress_;
    LeastSquaresReport& report_;
    Eigen::VectorXd internal_, residuals_;  // point of the last evaluation, internal values
    Eigen::MatrixXd last_;                  // last Jacobian, with respect to internal values
};

}  // namespace myo::inverse
