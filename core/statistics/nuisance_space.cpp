#include "statistics/nuisance_space.hpp"

#include <Eigen/QR>

#include <cassert>

namespace myo::statistics {

NuisanceSpace::NuisanceSpace(const Eigen::MatrixXd& J, double relative_tolerance) {
    Eigen::MatrixXd scaled = J;  // columns have different units
    for (Eigen::Index j = 0; j < J.cols(); ++j) {
        const double length = J.col(j).norm();
        if (length > 0.0) scaled.col(j) /= length;
    }
    basis_.resize(J.rows(), 0);
    if (J.cols() == 0 || J.rows() == 0) return;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
    qr.setThreshold(relative_tolerance);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(J.rows(), qr.rank());
}

Eigen::MatrixXd NuisanceSpace::outside(const Eigen::MatrixXd& X) const {
    assert(X.rows() == basis_.rows());
    Eigen::MatrixXd rest = X;
    // Two passes: rounding of the first pass is significant if nearly all of X is absorbed.
    for (int pass = 0; pass < 2; ++pass) rest -= basis_ * (basis_.transpose() * rest);
    return rest;
}

}  // namespace myo::statistics
