#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace myo::solver {

/// Lower triangle of a symmetric matrix, column-major, row indices ascending in each column.
using SymmetricSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Cholesky factor of a symmetric positive definite matrix in double precision, computed by CHOLMOD (supernodal).
///
/// CHOLMOD runs on one thread at a time; FastCholesky is preferred for search directions and preconditioning.
/// Source: Chen, Davis, Hager & Rajamanickam 2008.
class SparseCholesky {
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Symbolic analysis and numeric factorisation.
    /// @param lower  lower triangle, compressed, n x n
    /// @return       false if the matrix is not positive definite
    bool factorize(const SymmetricSparse& lower);

    /// True after a successful factorize().
    bool has_factor() const;

    /// Solution of A X = B for B of n x k. Asserts has_factor().
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Restricts BLAS and OpenMP to one thread via the environment, unless already set there: parallelism is organised
/// above them.
void use_one_blas_thread();

}  // namespace myo::solver
