#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Lines of a surface that remeshing keeps.
struct FeatureLines {
    std::vector<std::pair<int, int>> edges;  // vertex numbers, lower first; split and merged along the line only
    std::vector<int> corners;                // vertices that stay: ends, forks and bends of the lines
};

/// Surface with its remaining feature lines.
struct RemeshedSurface {
    SurfaceMesh surface;
    FeatureLines features;
};

/// Isotropic remeshing: edges become about `edge` long; vertices stay on the surface. Feature lines are split and
/// merged along themselves only, corners stay where they are.
///
/// @param surface     welded, closed, manifold, oriented
/// @param edge        [m]
/// @param iterations  of splitting, collapsing, flipping and relaxing
/// @return            empty if the surface cannot be remeshed
/// Source: Botsch & Kobbelt 2004, as implemented in CGAL.
std::optional<RemeshedSurface> isotropic_remesh(const SurfaceMesh& surface, const FeatureLines& features, double edge,
                                                int iterations);

}  // namespace myo::mesh
