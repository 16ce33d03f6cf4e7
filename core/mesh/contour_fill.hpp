#pragma once

#include <array>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Triangulates the region between closed planar contours, without additional vertices.
///
/// @param vertices  3 x n [m]
/// @param edges     directed pairs of vertex numbers; the region is on their left seen against `normal`, so holes have
///                  the opposite orientation
/// @param normal    unit normal of the plane; the triangles are oriented by it
/// Errors: contours that are open or cross.
Result<std::vector<std::array<int, 3>>> fill_contours(const Eigen::Matrix3Xd& vertices,
                                                      const std::vector<std::pair<int, int>>& edges,
                                                      const Eigen::Vector3d& normal);

}  // namespace myo::mesh
