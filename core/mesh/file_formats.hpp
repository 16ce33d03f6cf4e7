#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "mesh/volume_mesh.hpp"

// What the readers of single formats hand to read_surface and read_volume: contents as in the file, in its unit.

namespace myo::mesh {

struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;  // may be out of range: checked by read_surface
};

Result<PolygonSoup> read_stl(const std::filesystem::path& path);
Result<PolygonSoup> read_obj(const std::filesystem::path& path);
Result<PolygonSoup> read_ply(const std::filesystem::path& path);
Result<PolygonSoup> read_vtp(const std::filesystem::path& path);

/// Collects the volume cells of a file and refuses a second type.
struct CellSoup {
    std::vector<Eigen::Vector3d> nodes;
    CellType type = CellType::hex8;
    std::vector<int> cells;  // nodes_per_cell each, VTK order; may be out of range: checked by read_volume

    bool accepts(CellType other) const { return cells.empty() || type == other; }
};

Result<CellSoup> read_vtu(const std::filesystem::path& path);
Result<CellSoup> read_legacy_vtk(const std::filesystem::path& path);
Result<CellSoup> read_gmsh(const std::filesystem::path& path);
Result<CellSoup> read_tetgen(const std::filesystem::path& path);

}  // namespace myo::mesh
