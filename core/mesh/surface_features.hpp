#pragma once

#include "mesh/isotropic_remesh.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

struct FeaturePolicy {
    double sharp_deg = 30.0;    // between the normals of neighbours: an edge of the body; a round of 12 sides has 30
    double bend_deg = 30.0;     // of a feature line: a corner of the body
    double flat_deg = 0.1;      // between the normals of neighbours in one flat face; STL rounds a normal to 0.001
    double face_breadth = 1.0;  // 4 area / circumference of a flat face whose contour is kept, over the edge asked for
};
inline constexpr FeaturePolicy feature_policy;

/// Sharp edges, contours of broad flat faces, and the corners of both.
///
/// @param surface    welded, closed, manifold, oriented
/// @param edge       [m] that the surface will have; narrower flat faces are facets of a round
/// @param deviation  [m]; bent lines get so many corners that edges between them are not farther off
FeatureLines feature_lines(const SurfaceMesh& surface, double edge, double deviation);

}  // namespace myo::mesh
