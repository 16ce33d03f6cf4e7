#pragma once

#include <Eigen/Core>

#include "base/box.hpp"

namespace myo::mesh {

/// A triangulated surface: vertices 3 x n [m], mesh frame; triangles 3 x m, 0-based, outward by the right hand rule.
struct SurfaceMesh {
    Eigen::Matrix3Xd vertices;
    Eigen::Matrix3Xi triangles;
};

/// Bounding box. Asserts that the surface has vertices.
Box bounding_box(const Eigen::Matrix3Xd& points);

/// Volume enclosed by a closed outward surface [m3] (divergence theorem); negative when oriented inward.
double enclosed_volume(const SurfaceMesh& surface);

/// The 12 triangles of a box.
SurfaceMesh box_surface(const Box& box);

}  // namespace myo::mesh
