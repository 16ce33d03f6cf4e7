#pragma once

#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Removes the short edges that cutting a surface by planes leaves, which a mesher would fill with needlessly small
/// cells.
///
/// A vertex is moved into a neighbour that lies on the same planes and more, where the edge between them is shorter
/// than half of `edge` and of its longest neighbour, no triangle around it turns over, and none of them moves by more
/// than `deviation`.
/// @param planes     coordinates per axis [m] that vertices on them have exactly
/// @param edge       of the cells to come [m]
/// @param deviation  [m]
SurfaceMesh without_short_edges(const SurfaceMesh& surface, const GridPlanes& planes, double edge, double deviation);

}  // namespace myo::mesh
