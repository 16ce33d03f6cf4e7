#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <tuple>

#include "mesh/cell_hex8.hpp"
#include "mesh/cell_tet10.hpp"
#include "mesh/cell_tet4.hpp"

namespace myo::mesh {

/// All cells of meshes, in the order of CellType. A cell is a struct with
///
///   type, nodes                              value of CellType, number of nodes
///   values(xi), derivatives(xi)              shape functions N, dN/dxi, in VTK's node order
///   reference_corners(), _centroid()         of the reference cell, 3 x n and 3
///   strain_rule()                            smallest rule for the strains of a straight-sided cell
///   mass_rule(), volume_rule()               rules for products of two shape functions, and for det J
///   traits()                                 topology and file codes
///
/// A new cell is one such file, its place in this list, and its name in CellType.
using Cells = std::tuple<Hex8, Tet4, Tet10>;

/// Calls visit(Cell{}) with the cell of a type: a choice at run time becomes one of types, with loops of fixed length.
template <std::size_t I = 0, class Visit>
decltype(auto) with_cell(CellType type, const Visit& visit) {
    using Cell = std::tuple_element_t<I, Cells>;
    static_assert(static_cast<std::size_t>(Cell::type) == I, "the list has the order of CellType");
    if constexpr (I + 1 < std::tuple_size_v<Cells>)
        if (type != Cell::type) return with_cell<I + 1>(type, visit);
    return visit(Cell{});
}

/// Nodes of a cell of a mesh [m].
template <class Cell>
Eigen::Matrix<double, 3, Cell::nodes> cell_nodes(const VolumeMesh& mesh, Eigen::Index cell) {
    Eigen::Matrix<double, 3, Cell::nodes> X;
    for (int a = 0; a < Cell::nodes; ++a) X.col(a) = mesh.nodes.col(mesh.cells(a, cell));
    return X;
}

/// Volumes of all cells of a mesh [m3], see cell_volumes().
template <class Cell>
Eigen::VectorXd volumes_of(const VolumeMesh& mesh) {
    const std::vector<QuadraturePoint> rule = Cell::volume_rule();
    Eigen::VectorXd volumes = Eigen::VectorXd::Zero(mesh.cell_count());
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto X = cell_nodes<Cell>(mesh, c);
        for (const QuadraturePoint& point : rule) {
            const Eigen::Matrix3d jacobian = X * Cell::derivatives(point.xi);
            volumes[c] += point.weight * jacobian.determinant();
        }
    }
    return volumes;
}

}  // namespace myo::mesh
