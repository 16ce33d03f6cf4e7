#pragma once

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Plane perpendicular to a coordinate axis.
struct AxisPlane {
    int axis = 0;     // 0 x, 1 y, 2 z
    double at = 0.0;  // [m] coordinate of the plane
};

/// Splits triangles that cross a plane inside `where` at the plane. The shape is unchanged, a closed surface stays
/// closed, and new vertices have exactly the coordinate of the plane.
/// @param where  triangles outside of this box are not split
SurfaceMesh cut_by_plane(const SurfaceMesh& surface, const AxisPlane& plane, const Box& where);

/// Moves vertices close to a plane onto it.
///
/// @param distance  largest displacement [m]; further limited to a tenth of the shortest edge at the vertex
SurfaceMesh snapped_to_plane(SurfaceMesh surface, const AxisPlane& plane, double distance);

}  // namespace myo::mesh
