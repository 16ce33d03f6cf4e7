#pragma once

#include <array>

namespace myo::mesh {

// Local node numbering of VTK's cells. Source: vtkHexahedron, vtkTetra, vtkQuadraticTetra.

/// Corners of a hexahedron on the unit cube.
inline constexpr std::array<std::array<int, 3>, 8> hexahedron_corners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// Faces of a hexahedron, outward by the right-hand rule: x-, x+, y-, y+, z-, z+.
inline constexpr std::array<std::array<int, 4>, 6> hexahedron_faces{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

/// Edges of a hexahedron.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edges{
    {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// Edges of a tetrahedron. Edge e has the mid-side node 4 + e in tet10.
inline constexpr std::array<std::array<int, 2>, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Faces of a tetrahedron, outward: three corners, then the mid-side nodes of 01, 12, 20 (tet10 only).
inline constexpr std::array<std::array<int, 6>, 4> tetrahedron_faces{
    {{0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}, {0, 2, 1, 6, 5, 4}}};

}  // namespace myo::mesh
