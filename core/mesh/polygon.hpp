#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace myo::mesh {

/// Triangulates a simple polygon, convex or not (ear clipping in the plane of the mean normal).
///
/// @param polygon   vertex numbers in order, all in range
/// @param vertices  positions, any unit
/// @return          triangles of the same orientation; empty for fewer than three vertices
std::vector<std::array<int, 3>> triangles_of(const std::vector<int>& polygon,
                                             const std::vector<Eigen::Vector3d>& vertices);

}  // namespace myo::mesh
