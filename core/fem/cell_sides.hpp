#pragma once

#include <array>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// Neighbourhood of a cell: for hexahedra on both sides along one edge direction, for tetrahedra at the corners.
enum class CellSides {
    free,   // hexahedron: no cell on at least one side, next to a clamp on both; tetrahedron: one of one or two across
            // the body
    inner,  // hexahedron: cells on both sides, next to a clamp on one; all other tetrahedra
    clamped,  // hexahedron: a face on one side is clamped; tetrahedron: a corner is clamped and it is not free
};

/// Per cell: the three edge directions of a hexahedron; three equal entries for a tetrahedron.
using CellSurroundings = std::vector<std::array<CellSides, 3>>;

/// Classifies all cells of a mesh.
/// @param clamped  one flag per node
CellSurroundings cell_surroundings(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped);

}  // namespace myo::fem
