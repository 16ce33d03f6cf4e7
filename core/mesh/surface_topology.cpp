#include "mesh/surface_topology.hpp"

#include <algorithm>
#include <array>

#include "mesh/disjoint_sets.hpp"

namespace myo::mesh {
namespace {

// Use of an undirected edge by a triangle.
struct EdgeUse {
    int low = 0, high = 0;
    int triangle = 0;
    int side = 0;         // from corner `side` to the next
    bool forward = true;  // the triangle runs from low to high
};

/// Uses of all edges, those of one edge next to each other and ordered by triangle.
std::vector<EdgeUse> sorted_edges(const SurfaceMesh& surface) {
    std::vector<EdgeUse> uses;
    uses.reserve(static_cast<std::size_t>(surface.triangles.cols()) * 3);
    for (int t = 0; t < surface.triangles.cols(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const int a = surface.triangles(i, t), b = surface.triangles((i + 1) % 3, t);
            uses.push_back({std::min(a, b), std::max(a, b), t, i, a < b});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
    });
    return uses;
}

/// Calls visit(begin, end) for each run of uses of the same edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, const Visit& visit) {
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i + 1;
        while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
        visit(i, end);
        i = end;
    }
}

/// Number of a corner of a triangle among all corners.
std::size_t corner(int triangle, int side) { return static_cast<std::size_t>(3 * triangle + side % 3); }

/// Number of vertices where several fans of triangles meet. Corners of triangles that share an edge at a vertex are
/// joined; each remaining set at a vertex is one fan.
int pinched_vertices(const SurfaceMesh& surface, const std::vector<EdgeUse>& uses) {
    DisjointSets fans(static_cast<std::size_t>(surface.triangles.cols()) * 3);
    for_each_edge(uses, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin + 1; i < end; ++i) {
            const EdgeUse &a = uses[begin], &b = uses[i];
            // Corners of the two triangles at the same end of the edge, whichever way each runs along it.
            const auto low = [](const EdgeUse& e) { return corner(e.triangle, e.forward ? e.side : e.side + 1); };
            const auto high = [](const EdgeUse& e) { return corner(e.triangle, e.forward ? e.side + 1 : e.side); };
            fans.join(low(a), low(b));
            fans.join(high(a), high(b));
        }
    });
    std::vector<int> fans_at(static_cast<std::size_t>(surface.vertices.cols()), 0);
    for (int t = 0; t < surface.triangles.cols(); ++t) {
        for (int i = 0; i < 3; ++i) {
            if (fans.find(corner(t, i)) == corner(t, i)) ++fans_at[static_cast<std::size_t>(surface.triangles(i, t))];
        }
    }
    return static_cast<int>(std::count_if(fans_at.begin(), fans_at.end(), [](int n) { return n > 1; }));
}

}  // namespace

SurfaceTopology surface_topology(const SurfaceMesh& surface) {
    SurfaceTopology topology;
    const auto uses = sorted_edges(surface);
    DisjointSets sets(static_cast<std::size_t>(surface.triangles.cols()));
    for_each_edge(uses, [&](std::size_t begin, std::size_t end) {
        if (end - begin == 1) ++topology.open_edges;
        if (end - begin > 2) ++topology.crowded_edges;
        if (end - begin != 2) return;
        // Consistent neighbours traverse their common edge in opposite directions.
        if (uses[begin].forward == uses[begin + 1].forward) ++topology.turned_edges;
        sets.join(static_cast<std::size_t>(uses[begin].triangle), static_cast<std::size_t>(uses[begin + 1].triangle));
    });
    topology.part.resize(static_cast<std::size_t>(surface.triangles.cols()));
    for (std::size_t t = 0; t < topology.part.size(); ++t) {
        // The root is the smallest member and has thus been numbered before.
        const std::size_t root = sets.find(t);
        topology.part[t] = root == t ? topology.parts++ : topology.part[root];
    }
    topology.pinched_vertices = pinched_vertices(surface, uses);
    topology.closed = topology.open_edges == 0 && surface.triangles.cols() > 0;
    topology.manifold = topology.crowded_edges == 0 && topology.pinched_vertices == 0;
    topology.oriented = topology.turned_edges == 0;
    return topology;
}

}  // namespace myo::mesh
