#include "model/block_pattern.hpp"

#include <algorithm>
#include <cassert>

namespace myo::model {

BlockPattern block_pattern(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped) {
    assert(static_cast<Eigen::Index>(clamped.size()) == mesh.node_count());
    BlockPattern pattern;
    pattern.free_index.assign(clamped.size(), -1);
    for (std::size_t i = 0; i < clamped.size(); ++i)
        if (!clamped[i]) {
            pattern.free_index[i] = pattern.free_count++;
            pattern.free_nodes.push_back(static_cast<int>(i));
        }

    const auto nodes = static_cast<int>(mesh.cells.rows());
    const auto free_node = [&](Eigen::Index a, Eigen::Index c) {
        return pattern.free_index[static_cast<std::size_t>(mesh.cells(a, c))];
    };
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(pattern.free_count));  // block rows per block column
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        for (int b = 0; b < nodes; ++b)
            for (int a = 0; a < nodes; ++a)
                if (free_node(b, c) >= 0 && free_node(a, c) >= free_node(b, c))
                    rows[static_cast<std::size_t>(free_node(b, c))].push_back(free_node(a, c));
    std::size_t entries = 0;
    for (std::size_t column = 0; column < rows.size(); ++column) {
        rows[column].push_back(static_cast<int>(column));  // a node without cells keeps its diagonal
        std::sort(rows[column].begin(), rows[column].end());
        rows[column].erase(std::unique(rows[column].begin(), rows[column].end()), rows[column].end());
        // A block column has three scalar columns; the strict upper triangle of the diagonal block (3 entries) is not
        // stored.
        entries += 9 * rows[column].size() - 3;
    }

    solver::SymmetricSparse& matrix = pattern.zero;
    matrix.resize(pattern.unknowns(), pattern.unknowns());
    matrix.resizeNonZeros(static_cast<Eigen::Index>(entries));
    int position = 0;
    for (std::size_t column = 0; column < rows.size(); ++column)
        for (int s = 0; s < 3; ++s) {
            matrix.outerIndexPtr()[3 * static_cast<int>(column) + s] = position;
            for (std::size_t k = 0; k < rows[column].size(); ++k)
                for (int r = (k == 0 ? s : 0); r < 3; ++r) {
                    matrix.innerIndexPtr()[position] = 3 * rows[column][k] + r;
                    matrix.valuePtr()[position++] = 0.0;
                }
        }
    matrix.outerIndexPtr()[pattern.unknowns()] = position;

    // Rank of each cell block in its block column: assembly then needs no search.
    pattern.cell_blocks.assign(static_cast<std::size_t>(mesh.cell_count()) * static_cast<std::size_t>(nodes * nodes),
                               -1);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        for (int b = 0; b < nodes; ++b)
            for (int a = 0; a < nodes; ++a) {
                const int row = free_node(a, c), column = free_node(b, c);
                if (column < 0 || row < column) continue;
                const auto& list = rows[static_cast<std::size_t>(column)];
                const auto rank = std::lower_bound(list.begin(), list.end(), row) - list.begin();
                pattern.cell_blocks[static_cast<std::size_t>((c * nodes + b) * nodes + a)] = static_cast<int>(rank);
            }
    return pattern;
}

Eigen::VectorXd gather(const BlockPattern& pattern, const Eigen::Matrix3Xd& X) {
    Eigen::VectorXd v(pattern.unknowns());
    for (int i = 0; i < pattern.free_count; ++i)
        v.segment<3>(3 * i) = X.col(pattern.free_nodes[static_cast<std::size_t>(i)]);
    return v;
}

Eigen::Matrix3Xd scatter(const BlockPattern& pattern, const Eigen::VectorXd& v) {
    assert(v.size() == pattern.unknowns());
    Eigen::Matrix3Xd X = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(pattern.free_index.size()));
    for (int i = 0; i < pattern.free_count; ++i)
        X.col(pattern.free_nodes[static_cast<std::size_t>(i)]) = v.segment<3>(3 * i);
    return X;
}

}  // namespace myo::model
