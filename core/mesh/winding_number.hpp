#pragma once

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Times a closed outward surface winds round a point that is not on it: 1 inside, 0 outside.
/// Source: solid angles after Van Oosterom & Strackee 1983.
double winding_number(const SurfaceMesh& surface, const Eigen::Vector3d& point);

}  // namespace myo::mesh
