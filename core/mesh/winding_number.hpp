#pragma once

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Winding number of a closed surface around a point.
///
/// @param surface  closed, outward
/// @param point    not on the surface [m]
/// @return         1 inside, 0 outside, up to rounding
/// Source: solid angles after Van Oosterom & Strackee 1983.
double winding_number(const SurfaceMesh& surface, const Eigen::Vector3d& point);

}  // namespace myo::mesh
