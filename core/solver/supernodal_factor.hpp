#pragma once

#include <Eigen/Core>

#include <vector>

#include "solver/supernodal_pattern.hpp"

namespace myo::solver {

/// Numeric Cholesky factor L of D P A P' D with D = diag(A)^(-1/2), by supernodes.
///
/// Multifrontal method: a supernode adds the update matrices of its children and passes its own to its parent.
/// Independent subtrees run on different threads, and the order of summation does not depend on their number.
/// Source: Liu 1992 (the multifrontal method).
template <class Scalar>
struct SupernodalFactor {
    std::vector<Scalar, Eigen::aligned_allocator<Scalar>> values;  // dense blocks, see FactorBlock
    Eigen::VectorXd scale;                                         // n: diagonal of D in the order of A

    bool empty() const { return values.empty(); }
};

/// Numeric factorisation.
/// @param pattern  analysis of the same pattern as `lower`
/// @return         false, with an empty factor, if the matrix is not positive definite in this precision
template <class Scalar>
bool factorize(const SupernodalPattern& pattern, const SymmetricSparse& lower, SupernodalFactor<Scalar>& factor);

/// Solution X of A X = B, n x k. Right-hand sides are processed in groups of up to 16.
template <class Scalar>
Eigen::MatrixXd solve(const SupernodalPattern& pattern, const SupernodalFactor<Scalar>& factor,
                      const Eigen::Ref<const Eigen::MatrixXd>& B);

}  // namespace myo::solver
