#pragma once

#include <Eigen/Core>

// Decompositions of dense matrices behind a narrow interface: Eigen's decomposition headers take longer to compile than
// most files that need one.

namespace myo {

/// Spectral decomposition A = vectors diag(values) vectors' of a symmetric matrix.
struct SymmetricEigen {
    Eigen::VectorXd values;   // n, ascending
    Eigen::MatrixXd vectors;  // n x n, orthonormal columns
};

/// Spectral decomposition of a symmetric matrix.
/// @param A  n x n; only the lower triangle is read
/// Errors: none. A matrix with non-finite entries gives non-finite eigenvalues.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
/// Eigenvalues alone, ascending; same input as symmetric_eigen().
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

/// The smaller one of the Gram matrices A A' and A'A. Its eigenvalues are the squared singular values of A.
Eigen::MatrixXd smaller_gram(const Eigen::MatrixXd& A);

/// Truncated singular value decomposition A ~ left diag(sizes) right'.
struct LeadingSvd {
    Eigen::MatrixXd left;   // rows(A) x k
    Eigen::VectorXd sizes;  // k singular values, descending
    Eigen::MatrixXd right;  // cols(A) x k
};

/// Largest singular values and their vectors, computed from the eigenvectors of the smaller Gram matrix.
///
/// @param most  upper limit of the number k of singular values
/// @return      k <= most values. Values below 1e-7 of the largest are dropped: the Gram matrix squares the condition
///              number, so they are lost in rounding.
LeadingSvd leading_svd(const Eigen::MatrixXd& A, Eigen::Index most);

}  // namespace myo
