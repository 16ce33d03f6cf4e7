#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Mean length of the mesh's edges between corner nodes [m], each edge once.
double mean_edge_length(const VolumeMesh& mesh);

/// Shape of each cell: 1 perfect, 0 flat, negative turned inside out somewhere.
///
/// hex8: scaled Jacobian, the least over corners and centre of det(e1, e2, e3) / (|e1| |e2| |e3|) (Knupp 2003).
/// tet4, tet10: mean ratio of the corners 12 (3 V)^(2/3) / sum of squared edges (Liu & Joe 1994), 1 for the regular
/// one.
Eigen::VectorXd cell_shapes(const VolumeMesh& mesh);

struct QualityReport {
    std::string measure;             // "scaled Jacobian" or "mean ratio"
    double least = 0.0, mean = 0.0;  // of the measure
    int worst_cell = -1;
    std::array<int, 10> histogram{};  // cells per tenth of [0, 1]; below 0 counts in the first
    double least_dihedral_deg = 0.0, largest_dihedral_deg = 0.0;
    double mean_edge = 0.0;  // [m]

    Eigen::Index nodes = 0, cells = 0, dofs = 0;         // dofs = 3 nodes
    double volume = 0.0;                                 // [m3]
    std::optional<double> volume_error;                  // (volume - surface's volume) / surface's volume
    int components = 0, weak_edges = 0, weak_nodes = 0;  // see connectivity
    std::vector<std::string> messages;                   // what deserves a warning, one sentence each
};

/// @param surface  the closed surface the mesh was made from; without it volume_error stays empty
QualityReport mesh_quality(const VolumeMesh& mesh, const SurfaceMesh* surface = nullptr);

/// Predicted size of a mesh before it is made.
struct CountEstimate {
    double cells = 0.0, nodes = 0.0, dofs = 0.0;
    bool exact = false;  // a box filled with hexahedra
};

/// Cheap enough to follow a slider: one pass over the triangles. Typically within 20 % of what is made at edges below a
/// sixth of the body's width; near the surface's own edge lengths tetrahedra come out more.
/// @param surface  closed   @param edge  [m]
CountEstimate estimate_counts(const SurfaceMesh& surface, CellType type, double edge);

}  // namespace myo::mesh
