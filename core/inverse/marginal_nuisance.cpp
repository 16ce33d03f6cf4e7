#include "inverse/marginal_nuisance.hpp"

#include <cassert>
#include <utility>

#include "base/decompositions.hpp"

namespace myo::inverse {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MarginalNuisance::MarginalNuisance(MatrixXd A) : A_(std::move(A)) {
    if (A_.cols() == 0) return;
    SymmetricEigen gram = symmetric_eigen(A_.transpose() * A_);
    vectors_ = std::move(gram.vectors);
    values_ = gram.values.cwiseMax(0.0);  // rounding may leave negative ones
}

MatrixXd MarginalNuisance::whitened(const MatrixXd& X) const {
    if (empty()) return X;
    assert(X.rows() == A_.rows());
    // (I + A A')^(-1/2) = I + A V diag(((1 + l)^(-1/2) - 1) / l) V' A', with the quotient free of cancellation.
    const Eigen::ArrayXd root = (1.0 + values_.array()).sqrt();
    const VectorXd factor = -(root * (1.0 + root)).inverse();
    return X + A_ * (vectors_ * (factor.asDiagonal() * (vectors_.transpose() * (A_.transpose() * X))));
}

MatrixXd MarginalNuisance::power(double power, const MatrixXd& X) const {
    const VectorXd factor = (1.0 + values_.array()).pow(power);
    return vectors_ * (factor.asDiagonal() * (vectors_.transpose() * X));
}

// A' (I + A A')^(-1/2) = (I + A'A)^(-1/2) A', so that A'r = (I + A'A)^(1/2) A' whitened(r).
VectorXd MarginalNuisance::mean(const VectorXd& whitened) const {
    assert(whitened.size() == A_.rows());
    return -power(-0.5, A_.transpose() * whitened);
}

MatrixXd MarginalNuisance::covariance(const MatrixXd& whitened, const MatrixXd& covariance) const {
    assert(whitened.rows() == A_.rows() && whitened.cols() == covariance.rows());
    const MatrixXd B = power(-0.5, A_.transpose() * whitened);
    return power(-1.0, MatrixXd::Identity(A_.cols(), A_.cols())) + B * covariance * B.transpose();
}

}  // namespace myo::inverse
