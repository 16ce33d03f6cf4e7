#pragma once

#include "base/progress.hpp"
#include "mesh/surface_remesh.hpp"

namespace myo::setup {

/// Surface for tetrahedra of a given edge, see mesh::sized_surface(); thin walls stay as thick as they are.
///
/// @param edge  [m]
mesh::SizedSurface surface_for_tetrahedra(const mesh::SurfaceMesh& surface, double edge, const Progress& progress = {});

}  // namespace myo::setup
