#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Reads a surface: STL (ASCII, binary), OBJ, PLY, VTP, told apart by the extension.
///
/// @param metres_per_unit  length of the file's unit [m]; always asked for, none of these formats states it
/// @param rotation         mesh = rotation * (file * unit); orthonormal with determinant 1
/// @return  triangles as in the file, polygons cut into triangles; vertices that coincide are not joined: see weld
/// Errors: missing, empty, truncated or garbled file; no triangles; coordinates that are not finite; indices out of
/// range.
Result<SurfaceMesh> read_surface(const std::filesystem::path& path, double metres_per_unit,
                                 const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());

}  // namespace myo::mesh
