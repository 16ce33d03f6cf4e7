#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo {

/// Single-precision copy of a supernodal Cholesky factor, P A P' = L L', for preconditioning and search directions.
///
/// A solve costs one pass over the factor each way, at the speed of memory, so half the bytes are twice the speed; and it needs
/// no library beneath, so threads may solve side by side. Accuracy: about 1e-6 times the condition of A.
/// Source: Chen, Davis, Hager & Rajamanickam 2008 (storage); Higham 2002, ch. 12 (use beneath a double-precision iteration).
struct SupernodalFactor {
    std::vector<int> permutation;       // n: row k of P A P' is row permutation[k] of A
    std::vector<int> first_column;      // per supernode, and n
    std::vector<long> first_row;        // per supernode, into `rows`, and its end
    std::vector<long> first_value;      // per supernode, into `values`
    std::vector<int> rows;              // of each supernode, ascending, its own columns first
    std::vector<float> values;          // rows x columns of each supernode, column-major; above the diagonal: unused

    int size() const { return static_cast<int>(permutation.size()); }
    bool empty() const { return permutation.empty(); }

    /// A^-1 B for B of n x k.
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const;
};

}  // namespace myo
