#pragma once

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Boundary of a volume mesh as outward triangles: two per quadrilateral, four per face with mid-side nodes.
///
/// @return  vertices are the boundary nodes in their order in the mesh, without interior nodes
SurfaceMesh boundary_surface(const VolumeMesh& mesh);

}  // namespace myo::mesh
