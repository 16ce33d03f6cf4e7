#pragma once

#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Surface of a body cut along the faces of boxes, and the parts of these faces inside the body.
struct RegionFacets {
    SurfaceMesh surface;     // closed; some vertices may belong to inner triangles only
    Eigen::Matrix3Xi inner;  // triangles through the interior, vertex numbers of `surface`
};

/// Decides whether region_facets() cuts a body.
///
/// @param bounds  bounding box of the body [m]
/// @param edge    edge length of the future cells [m]
/// @return        true if a face of a region passes through the bounds
bool cut_by_regions(const Box& bounds, const std::vector<Box>& regions, double edge);

/// Cuts a body such that a mesh of its parts matches the boundary of (box intersected with body) for each box.
///
/// A face closer than a tenth of `edge` to the bounds of the body is not cut but selects that side. The shape is
/// preserved except near the planes, where vertices move by up to a hundredth of `edge` to avoid very short edges.
/// @param surface  welded, closed, manifold, outward
/// @param edge     edge length of the future cells [m]
/// @return         without inner triangles, and the surface as it is, if no face of a region cuts the body
/// Errors: a section that cannot be triangulated, or a change of shape; the input surface is then still valid.
Result<RegionFacets> region_facets(const SurfaceMesh& surface, const std::vector<Box>& regions, double edge);

}  // namespace myo::mesh
