#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Shape of the reference cell, whatever the number of its nodes.
enum class CellShape { hexahedron, tetrahedron };

/// Topology, node orders and file codes of a cell type; see Cells for the rest of a cell.
///
/// Nodes are numbered as in VTK: corners first, then mid-side nodes. Sources of the codes: vtkCellType.h; Gmsh
/// reference manual, "MSH file format" and "Node ordering".
struct CellTraits {
    CellType type;
    std::string name;  // in files and messages
    CellShape shape;
    int corners, nodes;                              // number of corners, and of all nodes
    std::vector<std::array<int, 2>> edges;           // corners at both ends
    std::vector<std::vector<int>> faces;             // outward by the right-hand rule: corners, then mid-side nodes
    int face_corners;                                // number of corners of a face; all faces have as many
    std::vector<std::array<int, 3>> face_triangles;  // of one face, by positions in its list of nodes
    std::vector<int> mirrored;                       // node order of the cell turned inside out
    int vtk_type;                                    // cell type of VTK files
    int gmsh_type;                                   // element type of MSH files
    std::vector<int> gmsh_order;                     // Gmsh's position of each node

    int face_nodes() const { return static_cast<int>(faces.front().size()); }
};

/// The first `count` nodes of each face of a table in cell_topology.hpp.
template <class Faces>
std::vector<std::vector<int>> face_lists(const Faces& faces, std::size_t count) {
    std::vector<std::vector<int>> lists;
    for (const auto& face : faces) lists.emplace_back(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(count));
    return lists;
}

/// The edges of a table in cell_topology.hpp.
template <class Edges>
std::vector<std::array<int, 2>> edge_list(const Edges& edges) {
    return {edges.begin(), edges.end()};
}

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
