#pragma once

#include <cstdint>
#include <vector>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// What is known of the Cholesky factor of P A P' before its values: the columns in groups with the same rows below,
/// the supernodes, each a dense block; the tree of their dependence; and where the entries of A go.
///
/// The tree is cut into subtrees that one thread takes each and the nodes above them. The cut depends on the pattern
/// alone, so that sums are taken in the same order on any number of threads. Source: Davis 2006, ch. 4; Liu 1992 (the
/// multifrontal method).
struct SupernodalPattern {
    static constexpr int stride_unit = 16;  // of row_stride(): 64 bytes

    std::vector<int> permutation;   // n: row k of P A P' is row permutation[k] of A
    std::vector<int> first_column;  // per supernode, and n
    std::vector<int> row_counts;    // per supernode
    std::vector<long> first_row;    // per supernode, into `rows`, and its end
    std::vector<long> first_value;  // per supernode, into the values, and their end
    std::vector<int> rows;          // of each supernode, ascending, its own columns first; filled up to row_stride()
    std::vector<int>
        parent_position;      // beside `rows`: for rows below the own columns, their place among the parent's rows
    std::vector<int> parent;  // per supernode, -1 at roots; parents come after their children
    std::vector<std::uint32_t> entry;  // per stored entry of A: its place among the values

    std::vector<std::vector<int>> children;  // per supernode, ascending
    std::vector<int> subtree_start;          // per supernode: at the root of a subtree its first supernode, else -1
    std::vector<int> roots;                  // of the tree

    int size() const { return static_cast<int>(permutation.size()); }
    int supernodes() const { return static_cast<int>(parent.size()); }
    int columns(int s) const {
        return first_column[static_cast<std::size_t>(s) + 1] - first_column[static_cast<std::size_t>(s)];
    }
    int row_count(int s) const { return row_counts[static_cast<std::size_t>(s)]; }
    /// Rows that a column of the supernode's block takes: whole cache lines of single precision, so that no pass over
    /// it needs an end of its own.
    int row_stride(int s) const {
        return static_cast<int>(first_row[static_cast<std::size_t>(s) + 1] - first_row[static_cast<std::size_t>(s)]);
    }
    long value_count() const { return first_value.empty() ? 0 : first_value.back(); }
};

/// Analyses the pattern of the lower triangle of a symmetric matrix: CHOLMOD's, with METIS ordering.
SupernodalPattern analyse_pattern(const SymmetricSparse& lower);

/// Floating-point operations of a factorisation.
double factor_flops(const SupernodalPattern& pattern);

}  // namespace myo::solver
