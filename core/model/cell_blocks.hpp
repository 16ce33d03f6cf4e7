#pragma once

#include <Eigen/Core>

#include <array>

#include "model/block_pattern.hpp"

namespace myo::model {

/// Range of free nodes, first ... end - 1: the block columns assembled by one thread.
struct OwnColumns {
    int first = 0, end = 0;
};

/// Destination of the blocks of one cell in an assembled matrix. Same result as BlockPattern::add, but the lookups that
/// the blocks of a cell share are done once; they dominate the cost of assembly. Blocks outside of the own columns are
/// skipped.
template <int N>
class CellBlocks {
public:
    CellBlocks() = default;
    /// @param own     block columns of this thread
    /// @param matrix  has the pattern's structure; must outlive the object
    CellBlocks(const BlockPattern& pattern, const Eigen::MatrixXi& cells, int cell, const OwnColumns& own,
               solver::SymmetricSparse& matrix)
        : ranks_(pattern.cell_blocks.data() + static_cast<std::size_t>(cell) * N * N) {
        for (int b = 0; b < N; ++b) {
            const int j = pattern.free_index[static_cast<std::size_t>(cells(b, cell))];
            if (j < own.first || j >= own.end) continue;
            const int* start = matrix.outerIndexPtr() + 3 * j;
            columns_[static_cast<std::size_t>(b)] = {matrix.valuePtr() + start[0], start[1] - start[0]};
        }
    }

    /// Adds the block (a, b), transposed if the order of the free nodes reverses the pair.
    /// @param entry  entry(r, s) = d2W / dx_ra dx_sb
    template <class Entry>
    void add(int a, int b, const Entry& entry) const {
        if (ranks_[b * N + a] >= 0)
            add_to(ranks_[b * N + a], columns_[static_cast<std::size_t>(b)], entry);
        else if (ranks_[a * N + b] >= 0)
            add_to(ranks_[a * N + b], columns_[static_cast<std::size_t>(a)], [&](int r, int s) { return entry(s, r); });
    }

private:
    struct BlockColumn {
        double* first = nullptr;  // values of the first scalar column; null: not in the own columns
        int length = 0;           // entries of that column; each of the next two is one shorter
    };

    /// Adds a block to the three scalar columns of its block column, each one entry shorter than the one before.
    template <class Entry>
    static void add_to(int rank, const BlockColumn& column, const Entry& entry) {
        if (!column.first) return;
        double* values = column.first + 3 * rank;
        for (int s = 0; s < 3; ++s) {
            for (int r = rank == 0 ? s : 0; r < 3; ++r) values[r] += entry(r, s);
            values += column.length - 1 - s;
        }
    }

    const int* ranks_ = nullptr;
    std::array<BlockColumn, N> columns_;
};

}  // namespace myo::model
