#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Grid coordinates per axis, ascending [m]: n + 1 values for n cells.
struct GridLines {
    std::array<std::vector<double>, 3> axis;  // x, y, z

    /// Number of cells per axis.
    Eigen::Vector3i cells() const {
        return {static_cast<int>(axis[0].size()) - 1, static_cast<int>(axis[1].size()) - 1,
                static_cast<int>(axis[2].size()) - 1};
    }
};

/// Coordinates per axis that must coincide with grid planes [m]; values outside of the box are ignored.
using GridPlanes = std::array<std::vector<double>, 3>;

/// Number of cells per axis for an edge length.
///
/// @param edge  target edge length [m], > 0
/// @return      round(extent / edge), at least 1, at most 1e9
Eigen::Vector3i box_cells(const Box& box, double edge);

/// Grid that matches the box and all planes inside of it exactly.
///
/// Between neighbouring planes the cells are equal, round(distance / edge) of them, at least 1. A plane closer than
/// 1e-6 of the extent to the box or to another plane counts as the same. Planes at a small distance produce flat cells;
/// avoiding them is up to the caller.
/// @param edge    target edge length [m], > 0
/// @param planes  coordinates that must be grid planes [m]
GridLines grid_lines(const Box& box, double edge, const GridPlanes& planes = {});

/// Target edge length [m] for an axis and a coordinate on it [m].
using EdgeAt = std::function<double(int axis, double at)>;

/// grid_lines() with variable edge length: each interval between planes uses the value at its midpoint.
GridLines grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes = {});

struct BoxMeshPolicy {
    /// Upper limit of grid cells. A larger number is treated as a typing error, because it would exhaust the memory.
    double max_grid_cells = 2e6;
};
inline constexpr BoxMeshPolicy box_mesh_policy;

/// grid_lines() with a check of the number of cells before memory is allocated.
/// Error: the complete grid would have more than max_cells cells.
Result<GridLines> limited_grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes = {},
                                     double max_cells = box_mesh_policy.max_grid_cells);
/// limited_grid_lines() with a uniform edge length [m].
Result<GridLines> limited_grid_lines(const Box& box, double edge, const GridPlanes& planes = {},
                                     double max_cells = box_mesh_policy.max_grid_cells);

/// Cubes of exactly `edge`, as many as fit completely: floor(extent / edge) per axis. The rest of the box stays empty,
/// as in published voxel meshes; for comparison.
///
/// @param from_highest  per axis: the cubes end at the highest side of the box instead of starting at the lowest
/// Errors: as limited_grid_lines(); edge longer than the box.
Result<GridLines> whole_cube_lines(const Box& box, double edge, const std::array<bool, 3>& from_highest,
                                   double max_cells = box_mesh_policy.max_grid_cells);

/// All cells of a grid as hex8.
///
/// @return  nodes and cells numbered with x fastest, then y, then z; asserts at least one cell per axis
VolumeMesh hex_mesh(const GridLines& grid);

/// Equal hex8 cells that fill the box exactly.
///
/// @param cells  number of cells per axis, > 0
VolumeMesh box_hex_mesh(const Box& box, const Eigen::Vector3i& cells);

/// Subdivision of grid cells into tetrahedra.
enum class Diagonals {
    equal,     // same in all cells: the common direction couples bending in the two planes
    mirrored,  // mirrored between neighbours: with even counts the mesh has the symmetry of the box
};

/// Six tetrahedra per grid cell around its main diagonal (Kuhn's subdivision). Faces match between cells.
///
/// @param cells      grid cells per axis, > 0
/// @param type       tet4 or tet10
/// @param diagonals  direction of the main diagonals in neighbouring grid cells
VolumeMesh tet_box_mesh(const Box& box, const Eigen::Vector3i& cells, CellType type = CellType::tet4,
                        Diagonals diagonals = Diagonals::equal);

/// Adds mid-side nodes to a tet4 mesh, at the midpoint of each edge.
///
/// @return  corner nodes first, then the mid-side nodes in ascending order of the edge's (lower, higher) corner
///          numbers; a tet10 mesh unchanged
VolumeMesh to_tet10(const VolumeMesh& mesh);

/// Box equal to a closed surface: all vertices lie on the six faces of the bounding box and the volumes agree.
///
/// @param tolerance  relative to the longest side; the default allows for single-precision files
/// @return           empty if the surface is not an axis-aligned box
std::optional<Box> is_box(const SurfaceMesh& surface, double tolerance = 1e-6);

}  // namespace myo::mesh
