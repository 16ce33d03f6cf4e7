#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Reads a surface file; the extension selects STL (ASCII, binary), OBJ, PLY or VTP.
///
/// @param metres_per_unit  length of the file's unit [m]; required, because none of these formats states it
/// @param rotation         mesh = rotation * (file * unit); orthonormal with determinant 1
/// @param warnings         sentences on defects that leave the file readable, such as bytes behind the last triangle,
/// are
///                         added; may be null
/// @return  triangles as in the file, polygons triangulated; coincident vertices are not merged, see weld()
/// Errors: missing, empty, truncated or corrupt file; no triangles; non-finite coordinates; indices out of range.
Result<SurfaceMesh> read_surface(const std::filesystem::path& path, double metres_per_unit,
                                 const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity(),
                                 std::vector<std::string>* warnings = nullptr);

}  // namespace myo::mesh
