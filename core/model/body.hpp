#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

#include "fem/element_block.hpp"
#include "mesh/volume_mesh.hpp"
#include "model/block_pattern.hpp"
#include "model/packed_cells.hpp"

namespace myo::model {

/// A discretised and clamped body: everything that depends on the mesh alone.
struct Body {
    mesh::VolumeMesh mesh;
    mesh::BoundaryFaces boundary;
    fem::ElementKind kind = fem::ElementKind::hex8;
    PackedElements cells;
    NodeIncidence incidence;
    std::vector<bool> clamped;           // per node
    fem::CellSurroundings surroundings;  // of hex8, as the body was made
    BlockPattern pattern;
    Eigen::SparseMatrix<double> unit_mass;  // n x n [m3]: consistent mass for density 1
    double volume_m3 = 0.0;
    int volume_points_per_cell = 1;  // independent volume measures (pressures) per cell
    int strains_per_cell = 0;
    int points_per_cell = 0;  // at which the law is evaluated

    int cell_count() const { return static_cast<int>(mesh.cell_count()); }
    int node_count() const { return static_cast<int>(mesh.node_count()); }
    int pack_count() const { return (cell_count() + pack_width - 1) / pack_width; }
    /// Entries of the per-cell fields of pressures, strains and points; see PackedCells.
    int volume_points() const { return pack_count() * pack_width * volume_points_per_cell; }
    int strain_count() const { return pack_count() * pack_width * strains_per_cell; }
    int point_count() const { return pack_count() * pack_width * points_per_cell; }
    /// Entry of point q of a cell in a field over the points.
    Eigen::Index point_entry(int cell, int q) const {
        return (cell / pack_width * points_per_cell + q) * pack_width + cell % pack_width;
    }
    /// Degrees of freedom before clamping, as the field counts them.
    int dofs() const { return 3 * node_count(); }
};

using BodyPointer = std::shared_ptr<const Body>;

/// clamped_nodes: nodes held still. Asserts that the kind fits the mesh.
BodyPointer make_body(mesh::VolumeMesh mesh, fem::ElementKind kind, const std::vector<int>& clamped_nodes);

}  // namespace myo::model
