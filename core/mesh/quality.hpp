#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Mean length of the edges between corner nodes [m], each edge counted once.
double mean_edge_length(const VolumeMesh& mesh);

/// Shape measure of each cell: 1 perfect, 0 flat, negative if inverted somewhere.
///
/// hex8: scaled Jacobian, the minimum over corners and centre of det(e1, e2, e3) / (|e1| |e2| |e3|). tet4, tet10: mean
/// ratio of the corner tetrahedron, 12 (3 V)^(2/3) / sum of squared edges, 1 for the regular one.
/// Source: Knupp 2003 (hex8); Liu & Joe 1994 (tetrahedra).
Eigen::VectorXd cell_shapes(const VolumeMesh& mesh);

/// Quality and size of a mesh.
struct QualityReport {
    std::string measure;              // "scaled Jacobian" or "mean ratio"
    double least = 0.0, mean = 0.0;   // of the shape measure
    int worst_cell = -1;              // cell with the smallest measure
    std::array<int, 10> histogram{};  // cells per tenth of [0, 1]; negative values count in the first bin
    double min_dihedral_deg = 0.0, largest_dihedral_deg = 0.0;  // over all cells
    double mean_edge = 0.0;                                     // [m]

    Eigen::Index nodes = 0, cells = 0, dofs = 0;         // dofs = 3 nodes
    double volume = 0.0;                                 // [m3]
    std::optional<double> volume_error;                  // (volume - surface's volume) / surface's volume
    int components = 0, weak_edges = 0, weak_nodes = 0;  // see connectivity()
    std::vector<std::string> messages;                   // warnings, one sentence each
};

/// Quality report of a mesh.
/// @param surface  closed surface from which the mesh was made; null: volume_error stays empty
QualityReport mesh_quality(const VolumeMesh& mesh, const SurfaceMesh* surface = nullptr);

/// Predicted size of a mesh.
struct CountEstimate {
    double cells = 0.0, nodes = 0.0, dofs = 0.0;
    bool exact = false;  // true for a box filled with hexahedra
};

/// Predicts the size of a mesh in one pass over the triangles, fast enough for interactive use. Typically within 20 %
/// for edges below a sixth of the width of the body; near the edge length of the surface itself tetrahedra are
/// underestimated.
/// @param surface  closed
/// @param edge     target edge length [m]
CountEstimate estimate_counts(const SurfaceMesh& surface, CellType type, double edge);

}  // namespace myo::mesh
