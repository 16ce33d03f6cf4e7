#pragma once

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// The boundary of a volume mesh as triangles, outward: two per quadrilateral, four per face with mid-side nodes. Nodes
/// inside are left out, the others keep their order.
SurfaceMesh boundary_surface(const VolumeMesh& mesh);

}  // namespace myo::mesh
