#pragma once

#include <string>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Mesh without the nodes that no cell uses.
///
/// @return  remaining nodes in their order, cells renumbered
VolumeMesh without_unused_nodes(const VolumeMesh& mesh);

/// Reorders the nodes of cells with negative volume, so that all volumes are positive, and removes unused nodes.
///
/// @param where  file or processing step named in the error
/// Errors: non-finite nodes, node numbers out of range, a cell without volume (reported by its number, from 0).
Result<VolumeMesh> with_positive_cells(VolumeMesh mesh, const std::string& where);

}  // namespace myo::mesh
