#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Distance below which two vertices count as one.
///
/// STL stores 32-bit numbers, which round at 6e-8 of the coordinate, so copies of a vertex may differ by that. A
/// millionth of the body (0.1 um for 100 mm) is far below any feature that could be meshed.
///
/// @return  [m], 1e-6 of the bounding box's diagonal, or four roundings of single precision at the largest coordinate
///          if that is more
double weld_tolerance(const SurfaceMesh& surface);

/// Merges close vertices and removes what becomes degenerate.
///
/// Thin triangles with three distinct corners are kept, even with zero area: removing them would open the surface.
///
/// @param tolerance  vertices closer than this [m] are merged; the first of them is kept
/// @return           without triangles with coincident corners, duplicate triangles (the first is kept) and unused
///                   vertices; order preserved
SurfaceMesh weld(const SurfaceMesh& surface, double tolerance);
/// weld() with weld_tolerance().
SurfaceMesh weld(const SurfaceMesh& surface);

/// Surface with reversed orientation: the last two corners of each triangle are exchanged.
SurfaceMesh flipped(SurfaceMesh surface);

/// Result of check_surface().
struct SurfaceReport {
    bool closed = false;         // each edge belongs to at least two triangles
    bool manifold = false;       // each edge belongs to at most two triangles, each vertex has one fan
    bool oriented = false;       // neighbouring triangles have consistent orientation
    bool outward = false;        // closed, oriented, and the enclosed volume is positive
    int open_edges = 0;          // edges of one triangle only
    int crowded_edges = 0;       // edges shared by more than two triangles
    int self_intersections = 0;  // pairs of triangles that cross or overlap
    std::vector<std::pair<int, int>> intersecting_pairs;  // the first 20 of them
    Eigen::Vector3d size = Eigen::Vector3d::Zero();       // [m]
    bool plausible = false;                               // largest extent between 1 mm and 10 m
    double area = 0.0;                                    // [m2]
    double volume = 0.0;                                  // [m3], meaningful if closed and oriented
    int components = 0;                                   // parts connected by shared edges
    std::vector<std::string> messages;                    // one sentence per defect; empty if there is none

    /// True if the surface can be meshed: closed, manifold and free of self-intersections.
    bool meshable() const { return closed && manifold && self_intersections == 0; }
};

/// Examines a surface before meshing.
/// @param surface  welded; triangle indices in range
SurfaceReport check_surface(const SurfaceMesh& surface);

/// Error if the largest extent is above 10 m or below 1 mm: the unit is almost certainly wrong.
/// @param size  extents of the bounding box [m]
Result<void> check_plausible_size(const Eigen::Vector3d& size);

/// Pairs of triangles that cross or overlap.
///
/// Triangles that only touch or share a corner or an edge are not reported, unless they are folded onto each other.
///
/// @param tolerance  smaller penetration [m] is ignored
/// @return           each pair once, ascending
std::vector<std::pair<int, int>> self_intersections(const SurfaceMesh& surface, double tolerance);

}  // namespace myo::mesh
