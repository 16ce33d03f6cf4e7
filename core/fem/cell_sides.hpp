#pragma once

#include <array>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// What lies around a cell: of a hexahedron at both sides along one of its edges, of a tetrahedron at its corners.
enum class CellSides {
    free,     // no other cell at one side at least, next to a clamp at both; a tetrahedron that is one of one or two
              // across the body
    inner,    // other cells at both sides, next to a clamp at one; all other tetrahedra
    clamped,  // a face at one side is held still; a corner of a tetrahedron that is not free
};

/// Per cell: along the three edges of a hexahedron; the same three times of a tetrahedron.
using CellSurroundings = std::vector<std::array<CellSides, 3>>;

/// clamped: per node.
CellSurroundings cell_surroundings(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped);

}  // namespace myo::fem
