#pragma once

#include <Eigen/Core>

#include "base/box.hpp"

namespace myo::mesh {

/// Triangulated surface in the mesh frame.
struct SurfaceMesh {
    Eigen::Matrix3Xd vertices;   // 3 x n [m]
    Eigen::Matrix3Xi triangles;  // 3 x m, vertex numbers from 0, outward by the right-hand rule
};

/// Bounding box of points.
///
/// @param points  3 x n [m]; asserts n > 0
Box bounding_box(const Eigen::Matrix3Xd& points);

/// Volume enclosed by a closed surface (divergence theorem).
///
/// @return  [m3], positive if outward, negative if inward; meaningless if the surface is open
double enclosed_volume(const SurfaceMesh& surface);

/// Surface of a box.
///
/// @return  8 vertices in VTK's corner order and 12 outward triangles
SurfaceMesh box_surface(const Box& box);

}  // namespace myo::mesh
