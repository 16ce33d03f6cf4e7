#include "mesh/cell_traits.hpp"

#include <vtkCellType.h>

#include <numeric>

#include "mesh/cell_topology.hpp"

namespace myo::mesh {
namespace {

/// The first `count` nodes of each face.
template <class Faces>
std::vector<std::vector<int>> face_lists(const Faces& faces, std::size_t count) {
    std::vector<std::vector<int>> lists;
    for (const auto& face : faces) lists.emplace_back(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(count));
    return lists;
}

template <class Edges>
std::vector<std::array<int, 2>> edge_list(const Edges& edges) {
    return {edges.begin(), edges.end()};
}

std::vector<int> in_order(int count) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

}  // namespace

// Sources: vtkCellType.h; Gmsh reference manual, "MSH file format" and "Node ordering".
const std::vector<CellTraits>& all_cell_traits() {
    static const std::vector<CellTraits> table = {{.type = CellType::hex8,
                                                   .name = "hex8",
                                                   .shape = CellShape::hexahedron,
                                                   .corners = 8,
                                                   .nodes = 8,
                                                   .edges = edge_list(hexahedron_edges),
                                                   .faces = face_lists(hexahedron_faces, 4),
                                                   .face_corners = 4,
                                                   .face_triangles = {{0, 1, 2}, {2, 3, 0}},
                                                   .mirrored = {4, 5, 6, 7, 0, 1, 2, 3},
                                                   .vtk_type = VTK_HEXAHEDRON,
                                                   .gmsh_type = 5,
                                                   .gmsh_order = in_order(8)},
                                                  {.type = CellType::tet4,
                                                   .name = "tet4",
                                                   .shape = CellShape::tetrahedron,
                                                   .corners = 4,
                                                   .nodes = 4,
                                                   .edges = edge_list(tetrahedron_edges),
                                                   .faces = face_lists(tetrahedron_faces, 3),
                                                   .face_corners = 3,
                                                   .face_triangles = {{0, 1, 2}},
                                                   .mirrored = {0, 2, 1, 3},
                                                   .vtk_type = VTK_TETRA,
                                                   .gmsh_type = 4,
                                                   .gmsh_order = in_order(4)},
                                                  {.type = CellType::tet10,
                                                   .name = "tet10",
                                                   .shape = CellShape::tetrahedron,
                                                   .corners = 4,
                                                   .nodes = 10,
                                                   .edges = edge_list(tetrahedron_edges),
                                                   .faces = face_lists(tetrahedron_faces, 6),
                                                   .face_corners = 3,
                                                   // The corner triangles and the one between the mid-side nodes.
                                                   .face_triangles = {{5, 0, 3}, {3, 1, 4}, {4, 2, 5}, {3, 4, 5}},
                                                   // The mid-side nodes of 01 and 02, and of 13 and 23, change places.
                                                   .mirrored = {0, 2, 1, 3, 6, 5, 4, 7, 9, 8},
                                                   .vtk_type = VTK_QUADRATIC_TETRA,
                                                   .gmsh_type = 11,
                                                   // Gmsh ends with 03, 23, 13; VTK with 03, 13, 23.
                                                   .gmsh_order = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}}};
    return table;
}

const CellTraits& cell_traits(CellType type) { return all_cell_traits()[static_cast<std::size_t>(type)]; }

std::optional<CellType> find_cell_type(const std::string& name) {
    for (const CellTraits& traits : all_cell_traits())
        if (traits.name == name) return traits.type;
    return std::nullopt;
}

std::vector<std::string> cell_type_names() {
    std::vector<std::string> names;
    for (const CellTraits& traits : all_cell_traits()) names.push_back(traits.name);
    return names;
}

std::vector<std::pair<std::string, CellType>> named_cell_types() {
    std::vector<std::pair<std::string, CellType>> named;
    for (const CellTraits& traits : all_cell_traits()) named.emplace_back(traits.name, traits.type);
    return named;
}

int nodes_per_cell(CellType type) { return cell_traits(type).nodes; }

std::string to_string(CellType type) { return cell_traits(type).name; }

}  // namespace myo::mesh
