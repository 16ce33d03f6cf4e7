#pragma once

#include <string>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Drops nodes that no cell uses; the order of the rest is kept.
VolumeMesh without_unused_nodes(const VolumeMesh& mesh);

/// Turns cells of negative volume round, in place of their node order.
/// Errors: a node that is not finite or out of range; a cell without volume (names its number, from 0).
/// @param where  file or step named in the error
Result<VolumeMesh> with_positive_cells(VolumeMesh mesh, const std::string& where);

}  // namespace myo::mesh
