#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

// Results of the format-specific readers for read_surface() and read_volume(): content of the file, in its unit.

namespace myo::mesh {

/// Triangles of a surface file; polygons are already triangulated.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;      // in the unit of the file
    std::vector<std::array<int, 3>> triangles;  // may be out of range: checked by read_surface()
    std::vector<std::string> warnings;          // defects that leave the file readable, one sentence each
};

/// STL, ASCII or binary.
/// Errors: missing, empty, truncated or corrupt file; the message names line or triangle.
Result<PolygonSoup> read_stl(const std::filesystem::path& path);
/// Wavefront OBJ: positions and faces; polygons are triangulated.
Result<PolygonSoup> read_obj(const std::filesystem::path& path);
/// PLY, ASCII or binary of either byte order; polygons are triangulated.
Result<PolygonSoup> read_ply(const std::filesystem::path& path);
/// VTK XML PolyData: polygons and triangle strips.
Result<PolygonSoup> read_vtp(const std::filesystem::path& path);

/// Volume cells of one type from a mesh file.
struct CellSoup {
    std::vector<Eigen::Vector3d> nodes;  // in the unit of the file
    CellType type = CellType::hex8;
    std::vector<int> cells;  // nodes_per_cell each, VTK order; may be out of range: checked by read_volume()

    std::vector<int> regions;  // one per cell, or none

    /// False if the file already contains cells of another type.
    bool accepts(CellType other) const { return cells.empty() || type == other; }
};

/// VTK XML UnstructuredGrid.
/// Errors: missing, empty, truncated or corrupt file; unsupported or mixed cell types.
Result<CellSoup> read_vtu(const std::filesystem::path& path);
/// VTK legacy unstructured grid, ASCII or binary, versions 1 to 5.1.
Result<CellSoup> read_legacy_vtk(const std::filesystem::path& path);
/// Gmsh MSH 2.2 or 4.1, ASCII.
Result<CellSoup> read_gmsh(const std::filesystem::path& path);
/// The two files of a TetGen mesh, which differ in their ending.
struct TetgenFiles {
    std::filesystem::path nodes, cells;
};
/// @param path  names either of the two
TetgenFiles tetgen_files(const std::filesystem::path& path);
/// TetGen .node and .ele; `path` names either of the two.
Result<CellSoup> read_tetgen(const std::filesystem::path& path);

}  // namespace myo::mesh
