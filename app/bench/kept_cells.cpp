#include "bench/kept_cells.hpp"

#include <vector>

namespace myo::bench {

mesh::VolumeMesh kept_cells(const mesh::VolumeMesh& mesh, const std::function<bool(const Eigen::Vector3d&)>& keep) {
    mesh::VolumeMesh kept;
    kept.type = mesh.type;
    // New number of each node, -1 where no kept cell uses it; and the nodes in the order of their new numbers.
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1), nodes;
    std::vector<Eigen::VectorXi> cells;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const Eigen::Matrix3Xd corners = mesh.nodes(Eigen::all, mesh.cells.col(c));
        if (!keep(corners.rowwise().mean())) continue;
        Eigen::VectorXi cell = mesh.cells.col(c);
        for (int& node : cell) {
            int& renumbered = number[static_cast<std::size_t>(node)];
            if (renumbered < 0) {
                renumbered = static_cast<int>(nodes.size());
                nodes.push_back(node);
            }
            node = renumbered;
        }
        cells.push_back(cell);
    }
    kept.nodes = mesh.nodes(Eigen::all, nodes);
    kept.cells.resize(mesh.cells.rows(), static_cast<Eigen::Index>(cells.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) kept.cells.col(static_cast<Eigen::Index>(c)) = cells[c];
    return kept;
}

}  // namespace myo::bench
