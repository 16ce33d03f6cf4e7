#pragma once

#include <array>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Fills closed contours in a plane with triangles between their vertices; none is added.
///
/// @param vertices  3 x n [m]
/// @param edges     directed, vertex numbers; the inside lies to their left seen against `normal`, so holes turn the
/// other way
/// @param normal    unit normal of the plane; the triangles turn about it
/// Errors: contours that are open or cross.
Result<std::vector<std::array<int, 3>>> fill_contours(const Eigen::Matrix3Xd& vertices,
                                                      const std::vector<std::pair<int, int>>& edges,
                                                      const Eigen::Vector3d& normal);

}  // namespace myo::mesh
