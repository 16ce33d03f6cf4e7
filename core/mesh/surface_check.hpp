#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Distance below which two vertices are one: 1e-6 of the bounding box's diagonal, or four roundings of single
/// precision at the largest coordinate, whichever is more.
///
/// STL holds 32-bit numbers, which round at 6e-8 of the coordinate: copies of one vertex may differ by that. A
/// millionth of the body (0.1 um for 100 mm) is far below any feature that could be meshed.
double weld_tolerance(const SurfaceMesh& surface);

/// Joins vertices nearer than the tolerance [m], then drops triangles that lost a corner, repeated triangles (the first
/// stays) and unused vertices. The first of joined vertices keeps its place; the order of the rest is kept.
///
/// Thin triangles with three distinct corners stay, even of zero area: without them the surface would be torn open.
SurfaceMesh weld(const SurfaceMesh& surface, double tolerance);
SurfaceMesh weld(const SurfaceMesh& surface);

/// All triangles turned round.
SurfaceMesh flipped(SurfaceMesh surface);

/// What is known about a surface before meshing. Made from a welded surface.
struct SurfaceReport {
    bool closed = false;    // no edge belongs to one triangle only
    bool manifold = false;  // no edge belongs to more than two, no vertex joins separate fans
    bool oriented = false;  // neighbours turn the same way
    bool outward = false;   // closed, oriented, and the enclosed volume is positive
    int open_edges = 0;
    int crowded_edges = 0;                                // shared by more than two triangles
    int self_intersections = 0;                           // pairs of triangles that cross or overlap
    std::vector<std::pair<int, int>> intersecting_pairs;  // the first 20 of them
    Eigen::Vector3d size = Eigen::Vector3d::Zero();       // [m]
    bool plausible = false;                               // largest extent within 1 mm and 10 m
    double area = 0.0;                                    // [m2]
    double volume = 0.0;                                  // [m3], meaningful when closed and oriented
    int components = 0;
    std::vector<std::string> messages;  // one sentence per finding, empty when all is well

    /// Fit to be meshed: closed, manifold, and free of self-intersections.
    bool meshable() const { return closed && manifold && self_intersections == 0; }
};

/// @param surface  welded; triangle indices in range
SurfaceReport check_surface(const SurfaceMesh& surface);

/// Error when the largest extent is above 10 m or below 1 mm: the unit is almost certainly wrong.
Result<void> check_plausible_size(const Eigen::Vector3d& size);

/// Pairs of triangles that cross or overlap by more than `tolerance` [m], each once, in ascending order. Triangles that
/// only touch, or share a corner or an edge, are not reported; folded over onto each other, they are.
std::vector<std::pair<int, int>> self_intersections(const SurfaceMesh& surface, double tolerance);

}  // namespace myo::mesh
