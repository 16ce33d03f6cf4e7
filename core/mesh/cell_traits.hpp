#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

enum class CellShape { hexahedron, tetrahedron };

/// Topology, node orders and file codes of a cell type. What else a new cell takes is listed in CONTRIBUTING.md.
///
/// Nodes are numbered as in VTK: corners first, then mid-side nodes.
struct CellTraits {
    CellType type;
    std::string name;  // in files and messages
    CellShape shape;
    int corners, nodes;
    std::vector<std::array<int, 2>> edges;  // corners at both ends
    std::vector<std::vector<int>> faces;    // outward by the right-hand rule: corners, then mid-side nodes
    int face_corners;
    std::vector<std::array<int, 3>> face_triangles;  // of one face, by positions in its list of nodes
    std::vector<int> mirrored;                       // node order of the cell turned inside out
    int vtk_type;
    int gmsh_type;
    std::vector<int> gmsh_order;  // Gmsh's position of each node

    int face_nodes() const { return static_cast<int>(faces.front().size()); }
};

/// Traits of a cell type.
const CellTraits& cell_traits(CellType type);
/// Traits of all cell types, in the order of CellType.
const std::vector<CellTraits>& all_cell_traits();

/// Cell type with a given name; empty if unknown.
std::optional<CellType> find_cell_type(const std::string& name);
/// Names of all cell types.
std::vector<std::string> cell_type_names();
/// Names of all cell types, each with its type.
std::vector<std::pair<std::string, CellType>> named_cell_types();

}  // namespace myo::mesh
