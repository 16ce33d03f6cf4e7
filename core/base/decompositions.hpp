#pragma once

#include <Eigen/Core>

// Decompositions of dense matrices, compiled once: each of them takes longer to compile than a file that needs it.

namespace myo {

/// A = vectors diag(values) vectors', values in ascending order.
struct SymmetricEigen {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Of a symmetric matrix of which the lower triangle is read. Values that are not finite where the matrix is not.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

/// The smaller of A A' and A'A: its eigenvalues are the squared singular values.
Eigen::MatrixXd smaller_gram(const Eigen::MatrixXd& A);

/// The leading part of a singular value decomposition: left diag(sizes) right', sizes in descending order.
struct LeadingSvd {
    Eigen::MatrixXd left;
    Eigen::VectorXd sizes;
    Eigen::MatrixXd right;
};

/// At most so many singular values with their vectors, from the smaller Gram matrix: without those below 1e-7 of the
/// largest, which it does not see.
LeadingSvd leading_svd(const Eigen::MatrixXd& A, Eigen::Index most);

}  // namespace myo
