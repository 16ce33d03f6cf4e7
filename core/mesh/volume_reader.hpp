#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Reads a volume mesh: VTU, legacy VTK unstructured grid, Gmsh MSH 2.2 and 4.1 (ASCII), TetGen .node/.ele (either of
/// the two names), told apart by the extension.
///
/// hex8, tet4 or tet10; points, lines and surface cells are ignored, two volume types in one file are an error. Cells
/// of negative volume are turned round, unused nodes dropped. VTK_VOXEL becomes hex8.
/// @param metres_per_unit  length of the file's unit [m]
/// Errors: missing, empty, truncated, garbled or binary (Gmsh) file; unsupported cells; a cell without volume.
Result<VolumeMesh> read_volume(const std::filesystem::path& path, double metres_per_unit);

}  // namespace myo::mesh
