#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "mesh/volume_mesh.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo::model {

/// A node that is held along some axes and free along the others, such as one on a roller.
struct GuidedNode {
    int node = 0;
    std::array<bool, 3> held{};  // per axis of the mesh frame
};

/// Sparsity pattern of the stiffness matrix in 3 x 3 blocks over the free nodes, lower triangle.
///
/// Free node i owns the unknowns 3 i ... 3 i + 2. Each block column holds its diagonal block first, then the blocks
/// below. Guided nodes count as free and keep all three unknowns: the held ones are eliminated by gather(), scatter()
/// and hold(), which leave them at zero.
struct BlockPattern {
    int free_count = 0;           // number of free nodes
    std::vector<int> free_index;  // per node: index among the free nodes; -1 if clamped
    std::vector<int> free_nodes;  // per free node: node
    // at (cell * N + b) * N + a: rank of block (a, b) in its block column; -1: not stored
    std::vector<int> cell_blocks;
    std::vector<std::vector<int>> coupled_blocks;  // the same for each coupling, with its number of nodes for N
    solver::SymmetricSparse zero;                  // matrix with this pattern and values 0
    std::vector<int> held_unknowns;                // of guided nodes, ascending
    std::vector<int> held_entries;                 // positions of values in their rows and columns, diagonal excluded

    int unknowns() const { return 3 * free_count; }

    /// Decouples the held unknowns: their rows and columns become zero but for a positive diagonal. With a right-hand
    /// side of gather() the solution is exactly that of the matrix without these rows and columns.
    ///
    /// @param matrix  has the pattern of `zero`
    void hold(solver::SymmetricSparse& matrix) const;

    /// True if the block (a, b) of a cell is free and in the stored triangle.
    bool stores(int nodes_per_cell, int cell, int a, int b) const {
        return cell_blocks[static_cast<std::size_t>((cell * nodes_per_cell + b) * nodes_per_cell + a)] >= 0;
    }

    /// Adds the block (a, b) of a cell. Clamped blocks and blocks above the diagonal are skipped.
    ///
    /// @param matrix  has the pattern of `zero`
    /// @param entry   entry(r, s) = d2W / dx_ra dx_sb [N/m]
    template <class Block>
    void add(solver::SymmetricSparse& matrix, const Eigen::MatrixXi& cells, int cell, int a, int b,
             const Block& entry) const {
        const auto nodes = static_cast<int>(cells.rows());
        add_ranked(matrix, cell_blocks[static_cast<std::size_t>((cell * nodes + b) * nodes + a)], cells(b, cell),
                   entry);
    }

    /// Adds the block (a, b) of a coupling, see block_pattern(). Clamped blocks and blocks above the diagonal are
    /// skipped.
    ///
    /// @param nodes  of the coupling
    template <class Block>
    void add_coupled(solver::SymmetricSparse& matrix, const std::vector<int>& nodes, std::size_t coupling,
                     std::size_t a, std::size_t b, const Block& entry) const {
        add_ranked(matrix, coupled_blocks[coupling][b * nodes.size() + a], nodes[b], entry);
    }

private:
    /// Adds a block at its rank in a block column; rank 0 is the diagonal block, of which the lower triangle is stored.
    template <class Block>
    void add_ranked(solver::SymmetricSparse& matrix, int rank, int column_node, const Block& entry) const {
        if (rank < 0) return;
        const int column = 3 * free_index[static_cast<std::size_t>(column_node)];
        for (int s = 0; s < 3; ++s) {
            double* values = matrix.valuePtr() + matrix.outerIndexPtr()[column + s];
            if (rank == 0)
                for (int r = s; r < 3; ++r) values[r - s] += entry(r, s);
            else
                for (int r = 0; r < 3; ++r) values[3 * rank - s + r] += entry(r, s);
        }
    }
};

/// Pattern of a mesh.
/// @param clamped    one flag per node
/// @param couplings  further groups of nodes that are coupled with each other, such as those that carry two guides of a
///                   tendon; a node occurs once in a group
/// @param guided     nodes that are held along some axes; clamped ones among them stay clamped
BlockPattern block_pattern(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped,
                           const std::vector<std::vector<int>>& couplings = {},
                           const std::vector<GuidedNode>& guided = {});

/// Free columns of a nodal field as one vector.
///
/// @param X  3 x n
/// @return   unknowns() entries; zero at held unknowns
Eigen::VectorXd gather(const BlockPattern& pattern, const Eigen::Matrix3Xd& X);
/// Inverse of gather().
///
/// @return  3 x n, zero columns at clamped nodes, zero along the held axes of guided ones
Eigen::Matrix3Xd scatter(const BlockPattern& pattern, const Eigen::VectorXd& v);

}  // namespace myo::model
