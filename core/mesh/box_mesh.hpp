#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Ascending grid coordinates per axis [m]: n + 1 values for n cells.
struct GridLines {
    std::array<std::vector<double>, 3> axis;

    Eigen::Vector3i cells() const {
        return {static_cast<int>(axis[0].size()) - 1, static_cast<int>(axis[1].size()) - 1,
                static_cast<int>(axis[2].size()) - 1};
    }
};

/// Coordinates per axis that must become grid planes [m]; those outside the box are ignored.
using GridPlanes = std::array<std::vector<double>, 3>;

/// Number of cells per axis whose edges come nearest `edge` [m]: round(extent / edge), at least 1, at most 1e9.
Eigen::Vector3i box_cells(const Box& box, double edge);

/// Grid that meets the box, and every plane inside it, exactly.
///
/// Between neighbouring planes the cells are equal, round(distance / edge) of them, at least 1. A plane nearer than
/// 1e-6 of the extent to the box or to another plane is taken as the same. Planes a small distance apart give
/// flat cells: that is the caller's choice.
GridLines grid_lines(const Box& box, double edge, const GridPlanes& planes = {});

/// Edge length [m] aimed at along an axis at a coordinate.
using EdgeAt = std::function<double(int axis, double at)>;

/// grid_lines() with an edge length that varies: each interval between planes takes that of its middle.
GridLines grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes = {});

/// More cells than this are taken for a slip of the keyboard: they would fill the memory.
inline constexpr double most_grid_cells = 2e6;

/// grid_lines(), refused before it takes memory when the whole grid would have more than max_cells.
/// Error: that many cells.
Result<GridLines> limited_grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes = {},
                                     double max_cells = most_grid_cells);
Result<GridLines> limited_grid_lines(const Box& box, double edge, const GridPlanes& planes = {},
                                     double max_cells = most_grid_cells);

/// Cubes of exactly `edge`, as many as fit whole: floor(extent / edge) per axis. They begin at the box's lowest side,
/// or end at its highest where `from_highest` says so, and leave the rest of the box empty. As published voxel meshes
/// do, for comparison. Errors: as limited_grid_lines(); an edge longer than the box.
Result<GridLines> whole_cube_lines(const Box& box, double edge, const std::array<bool, 3>& from_highest,
                                   double max_cells = most_grid_cells);

/// All cells of a grid as hex8. Nodes and cells are numbered with x fastest, then y, then z.
VolumeMesh hex_mesh(const GridLines& grid);

/// Equal hex8 cells that fill the box exactly.
VolumeMesh box_hex_mesh(const Box& box, const Eigen::Vector3i& cells);

/// How grid cells are divided into tetrahedra.
enum class Diagonals {
    alike,     // all cells: their common direction couples bending in one plane with bending in the other
    mirrored,  // neighbours in each other's faces: with even counts the mesh is as symmetric as the box
};

/// Six tetrahedra per grid cell around its main diagonal (Kuhn's subdivision), tet4 or tet10; faces match between
/// cells.
VolumeMesh tet_box_mesh(const Box& box, const Eigen::Vector3i& cells, CellType type = CellType::tet4,
                        Diagonals diagonals = Diagonals::alike);

/// Adds a node in the middle of every edge of a tet4 mesh, after the corner nodes, in ascending order of the edge's
/// (lower, higher) corner numbers. A tet10 mesh is returned unchanged.
VolumeMesh to_tet10(const VolumeMesh& mesh);

/// The box, when the closed surface is an axis-aligned box: every vertex lies on one of its six faces and the volumes
/// agree.
///
/// @param tolerance  relative to the longest side; the default forgives single precision files
std::optional<Box> is_box(const SurfaceMesh& surface, double tolerance = 1e-6);

}  // namespace myo::mesh
