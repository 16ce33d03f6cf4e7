#include "mesh/mesh_repair.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "mesh/cell_traits.hpp"

namespace myo::mesh {
namespace {

/// Turns a cell inside out, in its own node order.
void turn_round(CellType type, Eigen::Ref<Eigen::VectorXi> cell) {
    cell = Eigen::VectorXi(cell(cell_traits(type).mirrored));
}

}  // namespace

VolumeMesh without_unused_nodes(const VolumeMesh& mesh) {
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        for (Eigen::Index i = 0; i < mesh.cells.rows(); ++i) number[static_cast<std::size_t>(mesh.cells(i, c))] = 0;
    }
    std::vector<Eigen::Index> used;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] < 0) continue;
        number[i] = static_cast<int>(used.size());
        used.push_back(static_cast<Eigen::Index>(i));
    }
    VolumeMesh compact{mesh.type, mesh.nodes(Eigen::all, used), mesh.cells, mesh.regions};
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        for (Eigen::Index i = 0; i < mesh.cells.rows(); ++i) {
            compact.cells(i, c) = number[static_cast<std::size_t>(mesh.cells(i, c))];
        }
    }
    return compact;
}

Result<VolumeMesh> with_positive_cells(VolumeMesh mesh, const std::string& where) {
    if (mesh.cell_count() == 0) return Error{"the mesh has no volume cells", where};
    if (mesh.cells.minCoeff() < 0 || mesh.cells.maxCoeff() >= mesh.node_count()) {
        return Error{"a cell names a node that does not exist", where};
    }
    // Unused nodes may have arbitrary coordinates and must not fail the next check.
    mesh = without_unused_nodes(mesh);
    if (!mesh.nodes.allFinite()) return Error{"a node's coordinates are not finite numbers", where};
    const Eigen::VectorXd volumes = cell_volumes(mesh);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(c));
        const double extent = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
        // 1e-14: rounding level of the volume of a flat cell of this extent.
        if (!(std::abs(volumes[c]) > 1e-14 * extent * extent * extent)) {
            return Error{"cell " + std::to_string(c).append(" (counted from 0) has no volume"), where};
        }
        // Files of other programs may number the nodes in the opposite sense.
        if (volumes[c] < 0.0) turn_round(mesh.type, mesh.cells.col(c));
    }
    return mesh;
}

}  // namespace myo::mesh
