#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/volume_mesh.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo::model {

/// Where the 3 x 3 blocks of the cells' matrices go in the lower triangle over the free degrees of freedom.
///
/// Free node i owns the unknowns 3 i ... 3 i + 2. Each block column holds its diagonal block first, then the blocks
/// below.
struct BlockPattern {
    int free_count = 0;
    std::vector<int> free_index;   // per node: its number among the free nodes, or -1 when clamped
    std::vector<int> free_nodes;   // the inverse
    std::vector<int> cell_blocks;  // per cell, a + nodes_per_cell * b: rank in the block column of b, or -1: not stored
    solver::SymmetricSparse zero;  // the pattern, all values 0

    int unknowns() const { return 3 * free_count; }

    /// Whether the block (a, b) of a cell lies in the stored triangle and is free.
    bool stores(int nodes_per_cell, int cell, int a, int b) const {
        return cell_blocks[static_cast<std::size_t>((cell * nodes_per_cell + b) * nodes_per_cell + a)] >= 0;
    }

    /// Adds the block (a, b) of a cell, where entry(r, s) is d2W / dx_ra dx_sb. Skips what is clamped or above the
    /// diagonal.
    template <class Block>
    void add(solver::SymmetricSparse& matrix, const Eigen::MatrixXi& cells, int cell, int a, int b,
             const Block& entry) const {
        const auto nodes = static_cast<int>(cells.rows());
        const int rank = cell_blocks[static_cast<std::size_t>((cell * nodes + b) * nodes + a)];
        if (rank < 0) return;
        const int column = 3 * free_index[static_cast<std::size_t>(cells(b, cell))];
        for (int s = 0; s < 3; ++s) {
            double* values = matrix.valuePtr() + matrix.outerIndexPtr()[column + s];
            if (rank == 0)
                for (int r = s; r < 3; ++r) values[r - s] += entry(r, s);
            else
                for (int r = 0; r < 3; ++r) values[3 * rank - s + r] += entry(r, s);
        }
    }
};

/// clamped: one flag per node.
BlockPattern block_pattern(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped);

/// Free columns of X (3 x n) as one vector (3 x free), and back (clamped columns are zero).
Eigen::VectorXd gather(const BlockPattern& pattern, const Eigen::Matrix3Xd& X);
Eigen::Matrix3Xd scatter(const BlockPattern& pattern, const Eigen::VectorXd& v);

}  // namespace myo::model
