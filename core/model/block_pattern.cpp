#include "model/block_pattern.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace myo::model {
namespace {

using BlockRows = std::vector<std::vector<int>>;  // block rows per block column, diagonal first

/// Adds the blocks of a group of nodes to the stored triangle.
/// @param index  free index of node a of the group, -1: clamped
template <class Index>
void couple(std::size_t count, const Index& index, BlockRows& rows) {
    for (std::size_t b = 0; b < count; ++b)
        for (std::size_t a = 0; a < count; ++a)
            if (index(b) >= 0 && index(a) >= index(b)) rows[static_cast<std::size_t>(index(b))].push_back(index(a));
}

/// Rank of each block of a group in its block column: assembly then needs no search.
template <class Index>
void add_ranks(std::size_t count, const Index& index, const BlockRows& rows, int* ranks) {
    for (std::size_t b = 0; b < count; ++b)
        for (std::size_t a = 0; a < count; ++a) {
            const int row = index(a), column = index(b);
            if (column < 0 || row < column) continue;
            const std::vector<int>& list = rows[static_cast<std::size_t>(column)];
            ranks[b * count + a] = static_cast<int>(std::lower_bound(list.begin(), list.end(), row) - list.begin());
        }
}

/// Matrix of zeros with these blocks.
void set_zero_matrix(const BlockRows& rows, BlockPattern& pattern) {
    std::size_t entries = 0;
    // A block column has three scalar columns; the strict upper triangle of the diagonal block (3 entries) is not
    // stored.
    for (const std::vector<int>& column : rows) entries += 9 * column.size() - 3;
    solver::SymmetricSparse& matrix = pattern.zero;
    matrix.resize(pattern.unknowns(), pattern.unknowns());
    matrix.resizeNonZeros(static_cast<Eigen::Index>(entries));
    int position = 0;
    for (std::size_t column = 0; column < rows.size(); ++column)
        for (int s = 0; s < 3; ++s) {
            // Scalar columns of a block column follow each other; blocks above the diagonal are not stored.
            matrix.outerIndexPtr()[3 * static_cast<int>(column) + s] = position;
            for (std::size_t k = 0; k < rows[column].size(); ++k)
                for (int r = (k == 0 ? s : 0); r < 3; ++r) {
                    matrix.innerIndexPtr()[position] = 3 * rows[column][k] + r;
                    matrix.valuePtr()[position++] = 0.0;
                }
        }
    matrix.outerIndexPtr()[pattern.unknowns()] = position;
}

/// Unknowns of guided nodes along their held axes, and the entries that couple them to others.
void add_held(const std::vector<GuidedNode>& guided, BlockPattern& pattern) {
    std::vector<bool> is_held(static_cast<std::size_t>(pattern.unknowns()), false);
    for (const GuidedNode& node : guided) {
        const int i = pattern.free_index[static_cast<std::size_t>(node.node)];
        for (std::size_t axis = 0; i >= 0 && axis < 3; ++axis)
            if (node.held[axis]) is_held[static_cast<std::size_t>(3 * i) + axis] = true;
    }
    for (std::size_t u = 0; u < is_held.size(); ++u)
        if (is_held[u]) pattern.held_unknowns.push_back(static_cast<int>(u));
    if (pattern.held_unknowns.empty()) return;
    const solver::SymmetricSparse& matrix = pattern.zero;
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (int k = matrix.outerIndexPtr()[column]; k < matrix.outerIndexPtr()[column + 1]; ++k) {
            const int row = matrix.innerIndexPtr()[k];
            if (row != column && (is_held[static_cast<std::size_t>(row)] || is_held[static_cast<std::size_t>(column)]))
                pattern.held_entries.push_back(k);
        }
}

}  // namespace

void BlockPattern::hold(solver::SymmetricSparse& matrix) const {
    assert(held_unknowns.empty() || matrix.nonZeros() == zero.nonZeros());
    for (const int entry : held_entries) matrix.valuePtr()[entry] = 0.0;
    // The diagonal keeps its size, so that no scale of the matrix changes; the first entry of a column is its diagonal.
    for (const int unknown : held_unknowns) {
        double& diagonal = matrix.valuePtr()[matrix.outerIndexPtr()[unknown]];
        diagonal = diagonal != 0.0 ? std::abs(diagonal) : 1.0;
    }
}

BlockPattern block_pattern(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped,
                           const std::vector<std::vector<int>>& couplings, const std::vector<GuidedNode>& guided) {
    assert(static_cast<Eigen::Index>(clamped.size()) == mesh.node_count());
    BlockPattern pattern;
    pattern.free_index.assign(clamped.size(), -1);
    for (std::size_t i = 0; i < clamped.size(); ++i)
        if (!clamped[i]) {
            pattern.free_index[i] = pattern.free_count++;
            pattern.free_nodes.push_back(static_cast<int>(i));
        }
    const auto nodes = static_cast<std::size_t>(mesh.cells.rows());
    // Free index of the a-th node of a cell, or of a coupling.
    const auto in_cell = [&](Eigen::Index c) {
        return [&pattern, column = mesh.cells.data() + c * mesh.cells.rows()](std::size_t a) {
            return pattern.free_index[static_cast<std::size_t>(column[a])];
        };
    };
    const auto in_group = [&](const std::vector<int>& group) {
        return [&](std::size_t a) { return pattern.free_index[static_cast<std::size_t>(group[a])]; };
    };

    BlockRows rows(static_cast<std::size_t>(pattern.free_count));
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) couple(nodes, in_cell(c), rows);
    for (const std::vector<int>& group : couplings) couple(group.size(), in_group(group), rows);
    for (std::size_t column = 0; column < rows.size(); ++column) {
        rows[column].push_back(static_cast<int>(column));  // a node without cells keeps its diagonal
        std::sort(rows[column].begin(), rows[column].end());
        rows[column].erase(std::unique(rows[column].begin(), rows[column].end()), rows[column].end());
    }
    set_zero_matrix(rows, pattern);
    add_held(guided, pattern);

    pattern.cell_blocks.assign(static_cast<std::size_t>(mesh.cell_count()) * nodes * nodes, -1);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        add_ranks(nodes, in_cell(c), rows, pattern.cell_blocks.data() + static_cast<std::size_t>(c) * nodes * nodes);
    for (const std::vector<int>& group : couplings) {
        pattern.coupled_blocks.emplace_back(group.size() * group.size(), -1);
        add_ranks(group.size(), in_group(group), rows, pattern.coupled_blocks.back().data());
    }
    return pattern;
}

Eigen::VectorXd gather(const BlockPattern& pattern, const Eigen::Matrix3Xd& X) {
    Eigen::VectorXd v(pattern.unknowns());
    for (int i = 0; i < pattern.free_count; ++i)
        v.segment<3>(3 * i) = X.col(pattern.free_nodes[static_cast<std::size_t>(i)]);
    for (const int unknown : pattern.held_unknowns) v(unknown) = 0.0;
    return v;
}

Eigen::Matrix3Xd scatter(const BlockPattern& pattern, const Eigen::VectorXd& v) {
    assert(v.size() == pattern.unknowns());
    Eigen::Matrix3Xd X = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(pattern.free_index.size()));
    for (int i = 0; i < pattern.free_count; ++i)
        X.col(pattern.free_nodes[static_cast<std::size_t>(i)]) = v.segment<3>(3 * i);
    for (const int unknown : pattern.held_unknowns)
        X(unknown % 3, pattern.free_nodes[static_cast<std::size_t>(unknown / 3)]) = 0.0;
    return X;
}

}  // namespace myo::model
