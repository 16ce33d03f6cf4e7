#include "base/decompositions.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace myo {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
    return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& A) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

MatrixXd smaller_gram(const MatrixXd& A) {
    if (A.rows() <= A.cols()) return A * A.transpose();
    return A.transpose() * A;
}

LeadingSvd leading_svd(const MatrixXd& A, Index most) {
    if (A.size() == 0) return {MatrixXd(A.rows(), 0), VectorXd(), MatrixXd(A.cols(), 0)};
    const SymmetricEigen gram = symmetric_eigen(smaller_gram(A));
    // The relative bound 1e-14 on the squares is 1e-7 on the singular values: rounding level of the Gram matrix.
    const VectorXd squares = gram.values.reverse();
    const Index seen = (squares.array() > 1e-14 * squares(0)).count(), count = std::min(most, seen);
    LeadingSvd svd;
    svd.sizes = squares.head(count).cwiseSqrt();
    const MatrixXd near = gram.vectors.rowwise().reverse().leftCols(count);
    const VectorXd inverse = svd.sizes.cwiseInverse();
    // The vectors of the larger side follow from A v = sigma u. They cost one product instead of a second
    // decomposition.
    if (A.rows() <= A.cols()) {
        svd.left = near;
        svd.right = A.transpose() * near * inverse.asDiagonal();
    } else {
        svd.right = near;
        svd.left = A * near * inverse.asDiagonal();
    }
    return svd;
}

}  // namespace myo
