#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Core>

#include "mesh/cell_topology.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/voxel_mesh.hpp"

namespace myo {
namespace {

using Edge = std::pair<int, int>;

struct Face {
    std::array<int, 4> corners;  // ascending, -1 pads
    Eigen::Index cell;
};

std::vector<Face> sorted_faces(const VolumeMesh& mesh) {
    std::vector<Face> faces;
    const auto add = [&](Eigen::Index c, const auto& table, std::size_t corners) {
        for (const auto& local : table) {
            Face face{{-1, -1, -1, -1}, c};
            for (std::size_t i = 0; i < corners; ++i) face.corners[i] = mesh.cells(local[i], c);
            std::sort(face.corners.begin(), face.corners.end());
            faces.push_back(face);
        }
    };
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        if (mesh.type == CellType::hex8) add(c, hexahedron_faces, 4);
        else add(c, tetrahedron_faces, 3);
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.cell < b.cell;
    });
    return faces;
}

// Corner `node` of a cell, among `per_cell` slots.
std::size_t slot_of(const VolumeMesh& mesh, Eigen::Index cell, int node, std::size_t per_cell) {
    for (std::size_t i = 0; i < per_cell; ++i) {
        if (mesh.cells(static_cast<Eigen::Index>(i), cell) == node) return static_cast<std::size_t>(cell) * per_cell + i;
    }
    return static_cast<std::size_t>(cell) * per_cell;
}

// Twelve, of which a tetrahedron fills the first six.
std::array<Edge, 12> edges_of(const VolumeMesh& mesh, Eigen::Index cell) {
    std::array<Edge, 12> edges;
    edges.fill({-1, -1});
    const auto add = [&](const auto& table) {
        for (std::size_t i = 0; i < table.size(); ++i) {
            edges[i] = std::minmax(mesh.cells(table[i][0], cell), mesh.cells(table[i][1], cell));
        }
    };
    if (mesh.type == CellType::hex8) add(hexahedron_edges);
    else add(tetrahedron_edges);
    return edges;
}

// Number of distinct things (nodes, edges) that appear in more than one set.
template <class Key>
int in_several_sets(std::vector<std::pair<Key, std::size_t>>& members) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    int count = 0;
    for (std::size_t i = 0; i < members.size();) {
        std::size_t end = i + 1;
        while (end < members.size() && members[end].first == members[i].first) ++end;
        if (end - i > 1) ++count;
        i = end;
    }
    return count;
}

}  // namespace

Connectivity connectivity(const VolumeMesh& mesh) {
    const std::size_t corners = mesh.type == CellType::hex8 ? 8 : 4, sides = mesh.type == CellType::hex8 ? 12 : 6;
    const auto cells = static_cast<std::size_t>(mesh.cell_count());
    DisjointSets parts(cells), at_nodes(cells * corners), at_edges(cells * sides);
    const std::vector<Face> faces = sorted_faces(mesh);
    for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
        const Face &a = faces[f], &b = faces[f + 1];
        if (a.corners != b.corners) continue;
        parts.join(static_cast<std::size_t>(a.cell), static_cast<std::size_t>(b.cell));
        for (const int node : a.corners) {
            if (node >= 0) at_nodes.join(slot_of(mesh, a.cell, node, corners), slot_of(mesh, b.cell, node, corners));
        }
        const auto edges_a = edges_of(mesh, a.cell), edges_b = edges_of(mesh, b.cell);
        const auto on_face = [&](int node) { return std::find(a.corners.begin(), a.corners.end(), node) != a.corners.end(); };
        for (std::size_t i = 0; i < sides; ++i) {
            if (!on_face(edges_a[i].first) || !on_face(edges_a[i].second)) continue;
            const auto same = std::find(edges_b.begin(), edges_b.end(), edges_a[i]);
            if (same == edges_b.end()) continue;
            at_edges.join(static_cast<std::size_t>(a.cell) * sides + i,
                          static_cast<std::size_t>(b.cell) * sides + static_cast<std::size_t>(same - edges_b.begin()));
        }
    }

    Connectivity result;
    std::vector<std::pair<int, std::size_t>> nodes;
    std::vector<std::pair<Edge, std::size_t>> edges;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = static_cast<std::size_t>(c);
        if (parts.find(cell) == cell) ++result.components;
        for (std::size_t i = 0; i < corners; ++i) {
            nodes.emplace_back(mesh.cells(static_cast<Eigen::Index>(i), c), at_nodes.find(cell * corners + i));
        }
        const auto own = edges_of(mesh, c);
        for (std::size_t i = 0; i < sides; ++i) edges.emplace_back(own[i], at_edges.find(cell * sides + i));
    }
    result.weak_nodes = in_several_sets(nodes);
    result.weak_edges = in_several_sets(edges);
    return result;
}

}  // namespace myo
