#pragma once

#include <Eigen/Core>

namespace myo::statistics {

/// What recalibration of the declared model can absorb: the span of its Jacobian J (N x p).
class NuisanceSpace {
public:
    /// @param relative_tolerance  directions of J, its columns scaled to length 1, that are shorter do not count
    explicit NuisanceSpace(const Eigen::MatrixXd& J, double relative_tolerance = 1e-8);

    /// (I - J J^+) X, for X of N rows; J without columns leaves X as it is.
    Eigen::MatrixXd outside(const Eigen::MatrixXd& X) const;

    Eigen::Index rank() const { return basis_.cols(); }
    Eigen::Index rows() const { return basis_.rows(); }

private:
    Eigen::MatrixXd basis_;  // N x rank, orthonormal
};

}  // namespace myo::statistics
