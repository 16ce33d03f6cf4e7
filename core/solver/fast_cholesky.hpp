#pragma once

#include <Eigen/Core>

#include <vector>

#include "solver/supernodal_factor.hpp"
#include "solver/supernodal_pattern.hpp"

namespace myo::solver {

/// Cholesky factor in single precision, for preconditioning and search directions, kept while only the matrix's values
/// change.
///
/// A solve costs one pass over the factor each way, at the speed of memory, so half the bytes are twice the speed.
/// Accuracy: about 1e-6 times the condition of the scaled matrix. Where single precision breaks down it is factored in
/// double and rounded. Solves may run side by side. Source: Higham 2002, ch. 12 (single precision beneath a
/// double-precision iteration).
class FastCholesky {
public:
    /// Learns the pattern, and with it the size of the factor, when it is new.
    void analyse(const SymmetricSparse& lower);

    /// Analyses the pattern when it is new, then factors. False when the matrix is not positive definite.
    bool factorize(const SymmetricSparse& lower);

    bool has_factor() const { return !factor_.empty(); }

    /// A^-1 B for B of n x k. Asserts has_factor().
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
        return myo::solver::solve(pattern_, factor_, B);
    }

    /// Entries of the factor and floating-point operations to make it; 0 before the first analyse().
    double factor_entries() const { return static_cast<double>(pattern_.value_count()); }
    double factor_flops() const { return flops_; }

private:
    bool knows_pattern(const SymmetricSparse& lower) const;

    SupernodalPattern pattern_;
    SupernodalFactor<float> factor_;
    std::vector<int> starts_, rows_;  // of the matrix that the pattern was made for
    double flops_ = 0.0;
};

}  // namespace myo::solver
