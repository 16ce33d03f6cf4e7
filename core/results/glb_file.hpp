#pragma once

#include <Eigen/Core>

#include <filesystem>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::results {

/// Writes a surface as binary glTF 2.0: positions, normals, indices and colours.
///
/// glTF has metres and y upwards: the coordinates stay those of the mesh frame, and the node turns z to y. Normals are
/// the mean of those of the adjoining triangles, weighted by area.
///
/// @param surface  outward triangles [m]
/// @param colours  per vertex, red, green, blue as shown (sRGB), 0 to 1; empty: grey
/// Error: the file cannot be written.
/// Source: Khronos glTF 2.0 specification, sections 3.7 (accessors), 3.9.4 (COLOR_0 is linear) and 4.4 (GLB).
Result<void> write_glb(const std::filesystem::path& path, const mesh::SurfaceMesh& surface,
                       const Eigen::Matrix3Xf& colours);

}  // namespace myo::results
