#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Quality and limits of a tetrahedral mesh.
struct TetOptions {
    CellType type = CellType::tet4;  // tet4 or tet10
    std::optional<double> edge;      // [m] target mean edge length
    // Largest cell volume [m3]; takes precedence over `edge`. Neither: determined by the surface
    std::optional<double> max_volume;
    // Circumradius over shortest edge; clamped to >= 1.2, below which TetGen may not terminate. Empty: 1.414, or weaker
    // where bounds on angles, and not the edge asked for, would set the number of cells
    std::optional<double> radius_edge_ratio{};
    double min_dihedral_deg = 15.0;   // target, not guaranteed; clamped to [0, 20]
    int steiner_cap = 500'000;        // largest number of added points
    double time_limit_s = 60.0;       // for all runs together
    double max_cells = 2e6;           // larger meshes are an error
    double memory_limit_bytes = 4e9;  // of the worker process; 0: no limit
    std::vector<Box> regions{};       // boxes whose faces no cell may cross, see region_facets()
};

/// Cell volume limit [m3] that gives a mean edge close to `edge` [m]. Measured, see tet_mesh.cpp.
double tet_volume_for_edge(double edge);
/// Inverse of tet_volume_for_edge(): mean edge [m] for a cell volume limit [m3].
double tet_edge_for_volume(double max_volume);

/// Tetrahedral mesh inside a closed surface, made by TetGen in a separate process (myoloop-tetgen).
///
/// The surface is welded first. It may be refined but not changed: edges and planes are kept, except for the changes of
/// region_facets() near faces of regions. Edges cannot become longer than those of the surface. Inward parts are
/// cavities. Mid-side nodes of tet10 lie at the midpoints of straight edges.
///
/// Cancelling takes effect within 20 ms. No process or file is left behind.
/// Errors: open, non-manifold or self-intersecting surface; limits of time, cells, points or memory; cancelled; worker
/// missing.
Result<VolumeMesh> tetrahedralize(const SurfaceMesh& surface, const TetOptions& options, const Progress& progress = {});

}  // namespace myo::mesh
