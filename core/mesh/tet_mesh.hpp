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
    CellType type = CellType::tet4;    // tet4 or tet10
    std::optional<double> edge;        // [m] mean edge length aimed at
    std::optional<double> max_volume;  // [m3] of a cell; goes before `edge`. Neither: as the surface asks for
    double radius_edge_ratio = 1.414;  // circumradius over shortest edge; below 1.2 it may not end: clamped
    double min_dihedral_deg = 15.0;    // aimed at, not guaranteed; clamped to [0, 20]
    int steiner_cap = 500'000;         // points added at most
    double time_limit_s = 60.0;
    double max_cells = 2e6;
    double memory_limit_bytes = 4e9;  // of the worker; 0: none
    std::vector<Box> regions{};       // whose faces cells do not cross, see region_facets()
};

/// Largest cell volume that gives a mean edge near `edge`, and the other way round [m3, m]. Measured, see tet_mesh.cpp.
double tet_volume_for_edge(double edge);
double tet_edge_for_volume(double max_volume);

/// Tetrahedra inside a closed surface, by TetGen in a process of its own (myoloop-tetgen).
///
/// The surface is welded first. It may be refined, never changed: its edges and planes stay, but for what
/// region_facets() does near the faces of regions. Edges cannot become longer than the surface's. Inward parts are
/// cavities. Mid-nodes of tet10 lie on the middle of straight edges. Errors: open, not manifold or self-intersecting
/// surface; limits of time, cells, points, memory; cancelled; worker missing. A cancel takes effect within 20 ms; no
/// process and no file is left behind.
Result<VolumeMesh> tetrahedralize(const SurfaceMesh& surface, const TetOptions& options, const Progress& progress = {});

}  // namespace myo::mesh
