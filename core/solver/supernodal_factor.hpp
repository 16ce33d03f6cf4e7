#pragma once

#include <Eigen/Core>

#include <vector>

#include "solver/supernodal_pattern.hpp"

namespace myo::solver {

/// Values of the factor L of D P A P' D, D = diag(A)^(-1/2): each supernode's rows x columns, column-major, see
/// FactorBlock.
///
/// Every supernode gathers what its children leave for it and hands what it leaves to its parent, so that independent
/// subtrees go to different threads and sums do not depend on their number. Source: Liu 1992 (the multifrontal method).
template <class Scalar>
struct SupernodalFactor {
    std::vector<Scalar, Eigen::aligned_allocator<Scalar>> values;
    Eigen::VectorXd scale;  // diag(D), in A's order

    bool empty() const { return values.empty(); }
};

/// Factors the matrix. False, and an empty factor, when it is not positive definite in this precision.
template <class Scalar>
bool factorize(const SupernodalPattern& pattern, const SymmetricSparse& lower, SupernodalFactor<Scalar>& factor);

/// A^-1 B for B of n x k.
template <class Scalar>
Eigen::MatrixXd solve(const SupernodalPattern& pattern, const SupernodalFactor<Scalar>& factor,
                      const Eigen::Ref<const Eigen::MatrixXd>& B);

}  // namespace myo::solver
