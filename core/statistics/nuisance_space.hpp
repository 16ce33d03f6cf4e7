#pragma once

#include <Eigen/Core>

namespace myo::statistics {

/// Column space of the Jacobian J (N x p): residuals that recalibration of the declared model absorbs.
class NuisanceSpace {
public:
    /// Orthonormal basis by QR with column pivoting.
    /// @param J                   N x p, derivatives of the prediction over sigma
    /// @param relative_tolerance  directions below this length are dropped, with the columns of J scaled to length 1
    explicit NuisanceSpace(const Eigen::MatrixXd& J, double relative_tolerance = 1e-8);

    /// Orthogonal projection (I - J J^+) X for X of N rows; X itself if J has no columns.
    Eigen::MatrixXd outside(const Eigen::MatrixXd& X) const;

    /// Dimension of the space.
    Eigen::Index rank() const { return basis_.cols(); }
    /// N, number of residual entries.
    Eigen::Index rows() const { return basis_.rows(); }

private:
    Eigen::MatrixXd basis_;  // N x rank, orthonormal
};

}  // namespace myo::statistics
