#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace myo {

/// Lower triangle of a symmetric matrix, column-major, rows sorted.
using SymmetricSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Supernodal Cholesky factor of a symmetric positive definite matrix, kept while only its values change.
///
/// CHOLMOD with METIS ordering (Chen, Davis, Hager & Rajamanickam 2008). Not to be shared between threads.
class SparseCholesky {
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Analyses the pattern when it is new, then factors. False when the matrix is not positive definite.
    bool factorize(const SymmetricSparse& lower);

    bool has_factor() const;

    /// Solution of A X = B; B is n x k. Asserts has_factor().
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

    /// The same in single precision, for preconditioning and search directions; faster, and free of the library beneath.
    Eigen::MatrixXd solve_single(const Eigen::Ref<const Eigen::MatrixXd>& B) const;

    /// Entries of the factor and floating-point operations to make it.
    double factor_entries() const;
    double factor_flops() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Keeps the linear algebra underneath single-threaded, whichever BLAS is installed: threads belong to us.
void use_one_blas_thread();

}  // namespace myo
