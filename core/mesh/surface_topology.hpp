#pragma once

#include <vector>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// How the triangles of a surface hang together, whatever their shape.
struct SurfaceTopology {
    bool closed = false;    // no edge belongs to one triangle only
    bool manifold = false;  // no edge belongs to more than two, no vertex joins separate fans
    bool oriented = false;  // neighbours turn the same way
    int open_edges = 0;
    int crowded_edges = 0;     // shared by more than two triangles
    int pinched_vertices = 0;  // where fans meet that share no edge, as the tips of two cones
    int turned_edges = 0;      // between neighbours that turn opposite ways
    std::vector<int> part;     // per triangle: number of its part, joined through edges shared by two triangles
    int parts = 0;
};

/// @param surface  welded; triangle indices in range
SurfaceTopology surface_topology(const SurfaceMesh& surface);

}  // namespace myo::mesh
