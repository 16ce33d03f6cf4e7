#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

struct RemeshPolicy {
    /// Edge asked for over the mean shortest side of the triangles, weighted by area; above it the surface fixes the
    /// size of the cells. The bundled and the labelled bodies at their default edges stay below 2.6.
    double finer = 2.7;
    double max_deviation = 0.2;       // of the edge asked for; a round of this radius takes 4 edges
    double line_share = 0.5;          // of the deviation, by which edges may lie off sharp edges that are bent
    double max_volume_change = 0.01;  // relative, as in mesh_quality()
    /// First size tried, relative to the edge asked for: the cells that TetGen makes behind a round are a third shorter
    /// than its triangles.
    double first_size = 1.2;
    double size_step = 0.84;           // from size to size while the deviation is too large: 0.7 of the area
    int sizes = 24;                    // tried at most; a thin part may need a fiftieth of the edge asked for
    double worth = 0.7;                // of the triangles may remain, otherwise the surface is kept
    int iterations = 10;               // of remeshing; with half as many TetGen adds up to a fifth more cells
    int shifts = 2;                    // that restore the volume; the second changes it by a tenth of the first
    double cells_per_triangle = 10.0;  // that TetGen makes of a fine surface; measured 5 to 14
    double told_growth = 3.0;          // cells over those asked for, from which a surface that is kept is reported
};
inline constexpr RemeshPolicy remesh_policy;

/// Surface for tetrahedra of a given edge.
struct SizedSurface {
    SurfaceMesh surface;
    bool remeshed = false;
    double edge_m = 0.0;               // that it was remeshed to
    double deviation_m = 0.0;          // largest distance between the two surfaces
    double volume_change = 0.0;        // relative
    std::vector<std::string> notes{};  // one sentence on the change, or on what stands against it
};

/// Coarsens a surface whose triangles are much smaller than the cells asked for: TetGen keeps all edges of a surface.
///
/// Sharp edges and contours of flat faces are kept, flat faces stay flat; rounds keep their volume, so that vertices
/// move off the surface by half of what edges cut off. A surface that is coarse enough is returned as it is, likewise
/// one that cannot be coarsened within the deviation, with a note.
///
/// @param surface         welded
/// @param edge            of the cells [m], positive
/// @param most_deviation  [m]; the smaller of it and max_deviation of the edge holds
SizedSurface sized_surface(const SurfaceMesh& surface, double edge, double most_deviation,
                           const Progress& progress = {});

}  // namespace myo::mesh
