#pragma once

#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Settings of voxelize().
struct VoxelOptions {
    double edge = 0.005;  // [m] target edge length; adapted per axis so that the bounding box is matched exactly
    GridPlanes planes{};  // [m] coordinates that must be grid planes, for example faces of a clamp
    std::optional<GridLines> grid{};                    // [m] grid instead of edge and planes
    double solid_fraction = 0.5;                        // a cell is kept if at least this fraction of it lies inside
    double max_cells = box_mesh_policy.max_grid_cells;  // limit for the complete grid
};

/// Axis-aligned hex8 mesh of the interior of a closed surface.
///
/// The fraction of a cell inside is measured by 16 rays along z, each with its exact length inside.
/// @param surface  welded and closed. A consistently oriented surface is filled where the winding number is not zero:
///                 inward parts are cavities, overlapping parts one body. Other surfaces are filled by parity.
/// Errors: not closed; edge not positive; grid too large; no cell inside; cancelled.
Result<VolumeMesh> voxelize(const SurfaceMesh& surface, const VoxelOptions& options, const Progress& progress = {});

/// Connectivity of the cells of a mesh.
struct Connectivity {
    int components = 0;  // parts connected through complete faces
    int weak_edges = 0;  // edges where cells meet that are not connected by faces around the edge
    int weak_nodes = 0;  // nodes likewise, nodes of weak edges included
};
/// Connectivity of a mesh. Weak edges and nodes act as hinges, with almost no bending stiffness.
Connectivity connectivity(const VolumeMesh& mesh);

}  // namespace myo::mesh
