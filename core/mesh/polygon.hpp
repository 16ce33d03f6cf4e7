#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace myo::mesh {

/// Cuts a polygon, convex or not, into triangles that turn as it does (ear clipping in the plane of its mean normal).
/// @param polygon  vertex numbers in `vertices`, all in range; fewer than three give nothing
std::vector<std::array<int, 3>> triangles_of(const std::vector<int>& polygon,
                                             const std::vector<Eigen::Vector3d>& vertices);

}  // namespace myo::mesh
