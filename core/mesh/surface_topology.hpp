#pragma once

#include <vector>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Topology of a surface, independent of its geometry.
struct SurfaceTopology {
    bool closed = false;       // each edge belongs to at least two triangles
    bool manifold = false;     // each edge belongs to at most two triangles, each vertex has one fan
    bool oriented = false;     // neighbouring triangles have consistent orientation
    int open_edges = 0;        // edges of one triangle only
    int crowded_edges = 0;     // edges shared by more than two triangles
    int pinched_vertices = 0;  // vertices of several fans without a common edge, like the tips of two cones
    int turned_edges = 0;      // edges between triangles of opposite orientation
    std::vector<int> part;     // per triangle: its part, connected through edges shared by two triangles
    int parts = 0;             // number of parts
};

/// Topology of a surface.
/// @param surface  welded; triangle indices in range
SurfaceTopology surface_topology(const SurfaceMesh& surface);

}  // namespace myo::mesh
