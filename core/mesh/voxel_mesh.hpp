#pragma once

#include <optional>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

struct VoxelOptions {
    double edge = 0.005;                 // [m], aimed at; edges per axis adapt so that the bounding box is met exactly
    GridPlanes planes{};                 // [m] coordinates that must be grid planes, as the faces of a clamp
    std::optional<GridLines> grid{};     // [m] instead of edge and planes
    double solid_fraction = 0.5;         // a cell is kept when at least this part of it lies inside
    double max_cells = most_grid_cells;  // of the whole grid
};

/// Axis-aligned hex8 mesh of the inside of a closed surface.
///
/// How much of a cell is inside is measured along z: through each cell run 16 rays, and each gives the exact length
/// inside.
/// @param surface  welded and closed. Consistently oriented surfaces are filled where the winding number is not zero
/// (an
///                 inward part is a cavity, overlapping parts are one body); others by parity.
/// Errors: not closed; edge not positive; grid too large; no cell is inside; cancelled.
Result<VolumeMesh> voxelize(const SurfaceMesh& surface, const VoxelOptions& options, const Progress& progress = {});

/// How a mesh holds together.
struct Connectivity {
    int components = 0;  // parts joined through whole faces
    int weak_edges = 0;  // edges where parts of the mesh meet that share no face around it
    int weak_nodes = 0;  // nodes likewise, those of weak edges included
};
Connectivity connectivity(const VolumeMesh& mesh);

}  // namespace myo::mesh
