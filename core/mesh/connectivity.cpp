#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "mesh/cell_topology.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/voxel_mesh.hpp"

// Connectivity is examined node by node. A few dozen cells at most meet at a node, so the cost is linear in the size of
// the mesh.

namespace myo::mesh {
namespace {

constexpr int no_node = std::numeric_limits<int>::max();

/// Three edges and three faces meet at a corner of a cell. Local numbers of the corners at their other ends, padded by
/// -1.
struct CellCorner {
    std::array<int, 3> edges;
    std::array<std::array<int, 3>, 3> faces;
};

/// Table of all corners of a cell type, built at compile time from its edges and faces.
template <std::size_t Corners, class Edges, class Faces>
constexpr std::array<CellCorner, 8> corners_from(const Edges& edges, const Faces& faces) {
    // Mid-side nodes are ignored: connectivity is decided by corners.
    constexpr std::size_t face_corners = Corners == 8 ? 4 : 3;
    std::array<CellCorner, 8> table{};
    for (std::size_t i = 0; i < Corners; ++i) {
        const int corner = static_cast<int>(i);
        std::size_t e = 0, f = 0;
        for (const auto& edge : edges)
            if (edge[0] == corner || edge[1] == corner) table[i].edges[e++] = edge[0] == corner ? edge[1] : edge[0];
        for (const auto& face : faces) {
            if (std::find(face.begin(), face.begin() + face_corners, corner) == face.begin() + face_corners) continue;
            std::array<int, 3> others{-1, -1, -1};
            std::size_t found = 0;
            for (std::size_t k = 0; k < face_corners; ++k)
                if (face[k] != corner) others[found++] = face[k];
            table[i].faces[f++] = others;
        }
    }
    return table;
}

constexpr auto hexahedron_corner_table = corners_from<8>(hexahedron_edges, hexahedron_faces);
constexpr auto tetrahedron_corner_table = corners_from<4>(tetrahedron_edges, tetrahedron_faces);

/// Cell corners sorted by node, in compressed row format: those of node n are slot[first[n]] ... slot[first[n + 1] -
/// 1].
struct NodeCells {
    std::vector<int> first, slot;  // slot: cell * corners + corner
};

/// Lists the cell corners at every node of a mesh, by counting sort in two passes.
NodeCells cells_around_nodes(const VolumeMesh& mesh, int corners) {
    NodeCells around;
    around.first.assign(static_cast<std::size_t>(mesh.node_count()) + 2, 0);
    const auto count = static_cast<int>(mesh.cell_count());
    // Counts are stored two places ahead; filling then advances each start to its final value.
    for (int c = 0; c < count; ++c)
        for (int i = 0; i < corners; ++i) ++around.first[static_cast<std::size_t>(mesh.cells(i, c)) + 2];
    for (std::size_t n = 1; n < around.first.size(); ++n) around.first[n] += around.first[n - 1];
    around.slot.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(corners));
    for (int c = 0; c < count; ++c)
        for (int i = 0; i < corners; ++i)
            around.slot[static_cast<std::size_t>(
                around.first[static_cast<std::size_t>(mesh.cells(i, c)) + 1]++)] = c * corners + i;
    return around;
}

/// Face at a node: its other corners in ascending order, and the index of the cell around the node. Packed into two
/// words, because sorting these dominates the cost.
struct FaceAtNode {
    std::uint64_t two_corners, third_and_cell;

    FaceAtNode(std::array<int, 3> others, std::size_t cell) {
        if (others[0] > others[1]) std::swap(others[0], others[1]);
        if (others[1] > others[2]) std::swap(others[1], others[2]);
        if (others[0] > others[1]) std::swap(others[0], others[1]);
        const auto word = [](int node) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(node)); };
        two_corners = word(others[0]) << 32 | word(others[1]);
        third_and_cell = word(others[2]) << 32 | static_cast<std::uint64_t>(cell);
    }
    int corner(int i) const {
        return static_cast<int>(static_cast<std::uint32_t>(i == 0   ? two_corners >> 32
                                                           : i == 1 ? two_corners
                                                                    : third_and_cell >> 32));
    }
    std::size_t cell() const { return static_cast<std::uint32_t>(third_and_cell); }
    bool same_as(const FaceAtNode& other) const {
        return two_corners == other.two_corners && third_and_cell >> 32 == other.third_and_cell >> 32;
    }
    bool operator<(const FaceAtNode& other) const {
        return two_corners != other.two_corners ? two_corners < other.two_corners
                                                : third_and_cell < other.third_and_cell;
    }
};

/// Cells around one node. The buffers are reused from node to node.
class Star {
public:
    Star(const VolumeMesh& mesh, int corners)
        : mesh_(mesh), corners_(corners), table_(corners == 8 ? hexahedron_corner_table : tetrahedron_corner_table) {}

    /// Examines one node.
    /// @param slots   cell corners at the node, `count` of them
    /// @param parts   union-find over all cells of the mesh
    /// @param result  weak edges and nodes are added
    void look_at(int node, const int* slots, std::size_t count, DisjointSets& parts, Connectivity& result) {
        // Two unions per node: of cells that share a face at the node, and of cell edges that such faces carry.
        cells_.reset(count);
        edge_sets_.reset(3 * count);
        faces_.clear();
        edge_ends_.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const int cell = slots[k] / corners_;
            const CellCorner& corner = table_[static_cast<std::size_t>(slots[k] % corners_)];
            const auto node_at = [&](int local) { return local < 0 ? no_node : mesh_.cells(local, cell); };
            for (const int end : corner.edges) edge_ends_.push_back(node_at(end));
            for (const auto& [a, b, c] : corner.faces)
                faces_.emplace_back(std::array<int, 3>{node_at(a), node_at(b), node_at(c)}, k);
        }
        // Equal faces become adjacent; each pair joins two cells and three edges.
        std::sort(faces_.begin(), faces_.end());
        for (std::size_t f = 0; f + 1 < faces_.size(); ++f) {
            if (!faces_[f].same_as(faces_[f + 1])) continue;
            const std::size_t a = faces_[f].cell(), b = faces_[f + 1].cell();
            cells_.join(a, b);
            for (int i = 0; i < 3; ++i) join_edges(faces_[f].corner(i), a, b);
            // A face is seen from each of its corners; only the lowest one joins the cells in the mesh.
            if (node < faces_[f].corner(0))
                parts.join(static_cast<std::size_t>(slots[a] / corners_),
                           static_cast<std::size_t>(slots[b] / corners_));
        }
        // More than one set of cells that are connected by faces at this node: a weak node.
        std::size_t sets = 0;
        for (std::size_t k = 0; k < count; ++k) sets += cells_.find(k) == k ? 1 : 0;
        if (sets > 1) ++result.weak_nodes;
        result.weak_edges += weak_edges_to_higher_nodes(node);
    }

private:
    /// Joins the edges of cells a and b that end at the same node.
    void join_edges(int end, std::size_t a, std::size_t b) {
        const auto ends = edge_ends_.begin();
        const auto in_a = std::find(ends + 3 * static_cast<std::ptrdiff_t>(a),
                                    ends + 3 * static_cast<std::ptrdiff_t>(a) + 3, end);
        const auto in_b = std::find(ends + 3 * static_cast<std::ptrdiff_t>(b),
                                    ends + 3 * static_cast<std::ptrdiff_t>(b) + 3, end);
        // The corner of a quadrilateral opposite to the node is no end of an edge at the node.
        if (in_a == ends + 3 * static_cast<std::ptrdiff_t>(a) + 3 ||
            in_b == ends + 3 * static_cast<std::ptrdiff_t>(b) + 3)
            return;
        edge_sets_.join(static_cast<std::size_t>(in_a - ends), static_cast<std::size_t>(in_b - ends));
    }

    /// Edges to higher nodes whose cells form several face-connected sets; each edge is counted once.
    int weak_edges_to_higher_nodes(int node) {
        roots_.clear();
        for (std::size_t e = 0; e < edge_ends_.size(); ++e)
            if (edge_ends_[e] > node && edge_sets_.find(e) == e) roots_.push_back(edge_ends_[e]);
        std::sort(roots_.begin(), roots_.end());
        int weak = 0;
        for (std::size_t i = 0; i < roots_.size();) {
            const auto end = static_cast<std::size_t>(
                std::upper_bound(roots_.begin() + static_cast<std::ptrdiff_t>(i), roots_.end(), roots_[i]) -
                roots_.begin());
            if (end - i > 1) ++weak;
            i = end;
        }
        return weak;
    }

    const VolumeMesh& mesh_;
    int corners_;
    const std::array<CellCorner, 8>& table_;
    DisjointSets cells_{0}, edge_sets_{0};  // edge 3 k + i of the node: edge i of its k-th cell
    std::vector<FaceAtNode> faces_;
    std::vector<int> edge_ends_, roots_;
};

}  // namespace

Connectivity connectivity(const VolumeMesh& mesh) {
    const int corners = cell_traits(mesh.type).corners;
    Connectivity result;
    DisjointSets parts(static_cast<std::size_t>(mesh.cell_count()));
    const NodeCells around = cells_around_nodes(mesh, corners);
    Star star(mesh, corners);
    for (int n = 0; n < static_cast<int>(mesh.node_count()); ++n) {
        const auto i = static_cast<std::size_t>(n);
        star.look_at(n, around.slot.data() + around.first[i],
                     static_cast<std::size_t>(around.first[i + 1] - around.first[i]), parts, result);
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c)
        if (parts.find(c) == c) ++result.components;
    return result;
}

}  // namespace myo::mesh
