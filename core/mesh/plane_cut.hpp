#pragma once

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// The plane on which the coordinate `axis` is `at` [m].
struct AxisPlane {
    int axis = 0;
    double at = 0.0;
};

/// Splits the triangles that cross a plane where they meet it inside `where`; others stay whole. The shape does not
/// change, and a closed surface stays closed. Vertices on the plane have its coordinate exactly.
SurfaceMesh cut_by_plane(const SurfaceMesh& surface, const AxisPlane& plane, const Box& where);

/// Moves vertices nearer to the plane than `distance` [m] onto it, no farther than a tenth of their shortest edge.
SurfaceMesh snapped_to_plane(SurfaceMesh surface, const AxisPlane& plane, double distance);

}  // namespace myo::mesh
