#pragma once

#include <cstdint>
#include <vector>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// Symbolic Cholesky factor of P A P': supernodes, their elimination tree and the position of each entry of A.
///
/// A supernode is a group of consecutive columns with the same rows below, stored as one dense block. The tree is cut
/// into subtrees, each processed by one thread, and the supernodes above them. The cut depends on the pattern alone, so
/// the order of summation is the same on any number of threads.
/// Source: Davis 2006, ch. 4; Liu 1992 (the multifrontal method).
struct SupernodalPattern {
    static constexpr int stride_unit = 16;  // unit of row_stride(): 16 single-precision numbers are 64 bytes

    std::vector<int> permutation;      // n: row k of P A P' is row permutation[k] of A
    std::vector<int> first_column;     // per supernode, plus n at the end
    std::vector<int> row_counts;       // per supernode, own columns included
    std::vector<long> first_row;       // per supernode: start in `rows`, plus the end
    std::vector<long> first_value;     // per supernode: start in the factor's values, plus the end
    std::vector<int> rows;             // per supernode, ascending, own columns first; padded to row_stride()
    std::vector<int> parent_position;  // parallel to `rows`: index in the parent's rows, -1 for own columns
    std::vector<int> parent;           // per supernode; -1 at roots. A parent has a larger index than its children
    std::vector<std::uint32_t> entry;  // per stored entry of A: its index in the factor's values

    std::vector<std::vector<int>> children;  // per supernode, ascending
    std::vector<int> subtree_start;          // per supernode: first supernode of its subtree if on one thread, else -1
    std::vector<int> roots;                  // roots of the elimination forest

    /// Rows of A.
    int size() const { return static_cast<int>(permutation.size()); }
    /// Number of supernodes.
    int supernodes() const { return static_cast<int>(parent.size()); }
    /// Columns that supernode s owns.
    int columns(int s) const {
        return first_column[static_cast<std::size_t>(s) + 1] - first_column[static_cast<std::size_t>(s)];
    }
    /// Rows of the dense block of supernode s, own columns included.
    int row_count(int s) const { return row_counts[static_cast<std::size_t>(s)]; }
    /// Leading dimension of the block: rows rounded up to whole cache lines of single precision, so that SIMD loops
    /// need no remainder.
    int row_stride(int s) const {
        return static_cast<int>(first_row[static_cast<std::size_t>(s) + 1] - first_row[static_cast<std::size_t>(s)]);
    }
    /// Stored entries of the factor, padding included.
    long value_count() const { return first_value.empty() ? 0 : first_value.back(); }
};

/// Symbolic analysis by CHOLMOD with METIS ordering.
/// @param lower  lower triangle of a symmetric matrix, compressed
/// @return       size() == 0 if memory runs out, or if its task is cancelled meanwhile: see CancellationScope
SupernodalPattern analyse_pattern(const SymmetricSparse& lower);

/// Floating-point operations of one numeric factorisation.
double factor_flops(const SupernodalPattern& pattern);

}  // namespace myo::solver
