#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace myo::solver {

/// Lower triangle of a symmetric matrix, column-major, rows sorted.
using SymmetricSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Cholesky factor of a symmetric positive definite matrix in double precision, by CHOLMOD's supernodal method.
///
/// One thread at a time works in CHOLMOD; FastCholesky is the one for directions and preconditioning.
/// Source: Chen, Davis, Hager & Rajamanickam 2008.
class SparseCholesky {
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Analyses the pattern and factors. False when the matrix is not positive definite.
    bool factorize(const SymmetricSparse& lower);

    bool has_factor() const;

    /// Solution of A X = B; B is n x k. Asserts has_factor().
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Keeps the linear algebra underneath single-threaded, whichever BLAS is installed: threads belong to us.
void use_one_blas_thread();

}  // namespace myo::solver
