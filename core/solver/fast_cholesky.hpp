#pragma once

#include <Eigen/Core>

#include <vector>

#include "solver/supernodal_factor.hpp"
#include "solver/supernodal_pattern.hpp"

namespace myo::solver {

/// Cholesky factor in single precision, for preconditioners and search directions. The symbolic analysis is reused as
/// long as the pattern of the matrix stays the same.
///
/// A solve reads the factor twice and is bound by memory bandwidth, so half the bytes give twice the speed. Accuracy:
/// about 1e-6 times the condition number of the scaled matrix. If the factorisation breaks down in single precision, it
/// is repeated in double precision and rounded. solve() is thread-safe.
/// Source: Higham 2002, ch. 12 (single precision beneath a double-precision iteration).
class FastCholesky {
public:
    /// Symbolic analysis, skipped if the pattern is unchanged. Gives the size of the factor before any values are
    /// computed.
    /// @param lower  lower triangle, compressed, n x n
    void analyse(const SymmetricSparse& lower);

    /// Symbolic analysis if needed, then numeric factorisation.
    /// @return  false if the matrix is not positive definite or memory ran out in the analysis
    bool factorize(const SymmetricSparse& lower);

    bool has_factor() const { return !factor_.empty(); }

    /// Solution X of A X = B, n x k. Asserts has_factor(). Thread-safe.
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
        return myo::solver::solve(pattern_, factor_, B);
    }

    /// Stored entries of the factor; 0 before the first analyse().
    double factor_entries() const { return static_cast<double>(pattern_.value_count()); }
    /// Floating-point operations of one factorisation; 0 before the first analyse().
    double factor_flops() const { return flops_; }

private:
    bool knows_pattern(const SymmetricSparse& lower) const;

    SupernodalPattern pattern_;
    SupernodalFactor<float> factor_;
    std::vector<int> starts_, rows_;  // pattern of the analysed matrix (column starts, row indices)
    double flops_ = 0.0;
};

}  // namespace myo::solver
