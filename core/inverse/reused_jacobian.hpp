#pragma once

#include "inverse/least_squares.hpp"

namespace myo::inverse {

/// The Jacobian of a fit's points: worked out anew where the last one does not foretell the way from there.
///
/// Along a way s the residuals change by J s + s'Hs/2 and the Jacobian by Hs: where the last one misses a share of the
/// change of the residuals, it is wrong by twice that share at the end.
/// Source: Madsen, Nielsen & Tingleff 2004, Methods for non-linear least squares problems, 3.4.
class ReusedJacobian {
public:
    /// All are kept by reference. The jacobian may be empty: the evaluations have theirs, then.
    ReusedJacobian(const std::vector<Parameter>& parameters, const JacobianFunction& jacobian,
                   const LeastSquaresOptions& options, const Progress& progress, LeastSquaresReport& report);

    /// m x n; empty where the model could not be run beside these values. Of a cancelled fit the last there was.
    /// @param there  what was evaluated at the values
    Eigen::MatrixXd at(const Eigen::VectorXd& values, const ResidualEvaluation& there);

private:
    bool foretells(const Eigen::VectorXd& internal, const Eigen::VectorXd& residuals) const;
    Eigen::VectorXd internal(const Eigen::VectorXd& values) const;

    const std::vector<Parameter>& parameters_;
    const JacobianFunction& jacobian_;
    const LeastSquaresOptions& options_;
    const Progress& progress_;
    LeastSquaresReport& report_;
    Eigen::VectorXd internal_, residuals_;  // where the last one was worked out
    Eigen::MatrixXd last_;                  // of what the fit moves
};

}  // namespace myo::inverse
