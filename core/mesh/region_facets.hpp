#pragma once

#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// A body's surface cut along the faces of boxes, and those faces' parts inside the body.
struct RegionFacets {
    SurfaceMesh surface;     // closed; some vertices may belong to inner triangles only
    Eigen::Matrix3Xi inner;  // triangles through the inside, numbers of `surface.vertices`
};

/// Whether a face of a region passes through a body with these bounds, so that region_facets() cuts it.
bool cut_by_regions(const Box& bounds, const std::vector<Box>& regions, double edge);

/// Cuts a body so that a mesh of its parts meets the boundary of (box intersected with body) for every box.
///
/// A face nearer than a tenth of `edge` to the body's bounds is not cut: it selects that side. The surface keeps its
/// shape except near the planes, where vertices move by up to a hundredth of `edge` so that no needlessly short edges
/// arise.
/// @param surface  welded, closed, manifold, outward
/// @param edge     of the cells to come [m]
/// Errors: a section that cannot be filled, a shape that would change; the surface itself is then still good.
Result<RegionFacets> region_facets(const SurfaceMesh& surface, const std::vector<Box>& regions, double edge);

}  // namespace myo::mesh
