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

/// Discretised body with its clamped nodes: all data that depend on the mesh alone.
struct Body {
    mesh::VolumeMesh mesh;         // rest configuration [m]
    mesh::BoundaryFaces boundary;  // faces of the boundary
    fem::ElementKind kind = fem::ElementKind::hex8;
    PackedElements cells;                     // cell geometry in SIMD layout
    NodeIncidence incidence;                  // node to cell map for the assembly of nodal vectors
    std::vector<bool> clamped;                // per node
    std::vector<GuidedNode> guided;           // not clamped, held along some axes; ascending
    fem::CellSurroundings surroundings;       // neighbourhood of each hex8 cell, see fem::cell_surroundings()
    std::vector<std::vector<int>> couplings;  // groups of nodes that force elements couple, see block_pattern()
    BlockPattern pattern;                     // of the stiffness matrix
    Eigen::SparseMatrix<double> unit_mass;    // n x n [m3]: consistent mass for density 1
    double volume_m3 = 0.0;                   // [m3] rest volume
    int volume_points_per_cell = 1;           // independent volume measures (pressures) per cell
    int strains_per_cell = 0;                 // strain components per cell: 6 per point
    int points_per_cell = 0;                  // quadrature points, where the material law is evaluated

    /// Cells of the mesh; without the padding of packs.
    int cell_count() const { return static_cast<int>(mesh.cell_count()); }
    /// Nodes of the mesh, clamped ones included.
    int node_count() const { return static_cast<int>(mesh.node_count()); }
    /// Packs that hold the cells; the last one may be padded.
    int pack_count() const { return (cell_count() + pack_width - 1) / pack_width; }
    /// Length of a per-cell field of pressures, padded to full packs; see PackedCells.
    int volume_points() const { return pack_count() * pack_width * volume_points_per_cell; }
    /// Length of a field of strains, padded to full packs.
    int strain_count() const { return pack_count() * pack_width * strains_per_cell; }
    /// Length of a field over the quadrature points, padded to full packs.
    int point_count() const { return pack_count() * pack_width * points_per_cell; }
    /// Index of point q of a cell in a field over the points.
    Eigen::Index point_entry(int cell, int q) const {
        return (cell / pack_width * points_per_cell + q) * pack_width + cell % pack_width;
    }
    /// Degrees of freedom, clamped ones included.
    int dofs() const { return 3 * node_count(); }
};

/// Bodies are constant and shared between models.
using BodyPointer = std::shared_ptr<const Body>;

/// Builds the body.
/// @param kind           element formulation; asserts that it matches the cells of the mesh
/// @param clamped_nodes  nodes with prescribed zero displacement
/// @param couplings      see block_pattern()
/// @param guided         nodes that are held along some axes. What is held twice is held along all these axes; a node
///                       held along all three is clamped.
BodyPointer make_body(mesh::VolumeMesh mesh, fem::ElementKind kind, const std::vector<int>& clamped_nodes,
                      std::vector<std::vector<int>> couplings = {}, const std::vector<GuidedNode>& guided = {});

/// Field without its components at clamped nodes and along the held axes of guided ones, 3 x n.
Eigen::Matrix3Xd free_part(const Body& body, const Eigen::Matrix3Xd& field);

}  // namespace myo::model
