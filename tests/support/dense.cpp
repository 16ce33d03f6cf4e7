#include "support/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace myo::test {

using Eigen::MatrixXd;

Eigen::VectorXd least_squares(const MatrixXd& A, const Eigen::VectorXd& b) { return A.colPivHouseholderQr().solve(b); }

MatrixXd orthonormal(const MatrixXd& A) {
    return A.colPivHouseholderQr().householderQ() * MatrixXd::Identity(A.rows(), A.cols());
}

MatrixXd inverse(const MatrixXd& A) { return A.fullPivLu().inverse(); }

Eigen::Index rank(const MatrixXd& A) { return A.fullPivLu().rank(); }

}  // namespace myo::test
