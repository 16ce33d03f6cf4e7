#pragma once

#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Collapses the short edges that cutting by planes leaves. A mesher would fill them with very small cells.
///
/// A vertex moves to a neighbour that lies on all its planes if the edge is shorter than half of `edge` and of its
/// longest adjacent edge, no triangle flips, and none moves by more than `deviation`.
/// @param planes     coordinates per axis [m] of the cutting planes
/// @param edge       edge length of the future cells [m]
/// @param deviation  largest displacement normal to a triangle [m]
SurfaceMesh without_short_edges(const SurfaceMesh& surface, const GridPlanes& planes, double edge, double deviation);

}  // namespace myo::mesh
