#pragma once

#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Reads a volume mesh file; the extension selects VTU, legacy VTK unstructured grid, Gmsh MSH 2.2 and 4.1 (ASCII) or
/// TetGen .node/.ele (either of the two names).
///
/// Cells may be hex8, tet4 or tet10; VTK_VOXEL becomes hex8. Points, lines and surface cells are ignored. Cells of
/// negative volume are reordered, unused nodes removed.
/// Numbers of regions: the first physical tag of Gmsh, without one the elementary entity; TetGen's first attribute; in
/// VTU files an integer array of the cells with a usual name, see region_array(), or the only one.
/// @param metres_per_unit  length of the file's unit [m]
/// Errors: missing, empty, truncated, corrupt or binary (Gmsh) file; unsupported cells, two volume types in one file; a
/// cell without volume.
Result<VolumeMesh> read_volume(const std::filesystem::path& path, double metres_per_unit);

/// All files that read_volume() reads: `path`, or the two of TetGen.
std::vector<std::filesystem::path> volume_files(const std::filesystem::path& path);

}  // namespace myo::mesh
