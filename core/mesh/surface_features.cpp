#include "mesh/surface_features.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>

#include "mesh/disjoint_sets.hpp"
#include "mesh/surface_distance.hpp"

namespace myo::mesh {
namespace {

/// Edge between two triangles.
struct SharedEdge {
    int low = 0, high = 0, first = -1, second = -1;
    double turn_deg = 0.0;  // angle between the normals
};

/// Edges of two triangles with the angle between these, ordered by vertex numbers.
std::vector<SharedEdge> shared_edges(const SurfaceMesh& surface, const Eigen::Matrix3Xd& normals) {
    std::map<std::pair<int, int>, SharedEdge> found;
    for (int t = 0; t < surface.triangles.cols(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int a = surface.triangles(i, t), b = surface.triangles((i + 1) % 3, t);
            SharedEdge& edge = found[std::minmax(a, b)];
            edge.low = std::min(a, b), edge.high = std::max(a, b);
            (edge.first < 0 ? edge.first : edge.second) = t;
        }
    std::vector<SharedEdge> edges;
    for (auto& [ends, edge] : found) {
        if (edge.second < 0) continue;
        const Eigen::Vector3d n = normals.col(edge.first), m = normals.col(edge.second);
        // Triangles without area have no normal and make no edge sharp.
        if (!n.isZero(0.0) && !m.isZero(0.0))
            edge.turn_deg = std::atan2(n.cross(m).norm(), n.dot(m)) * 180.0 / std::numbers::pi;
        edges.push_back(edge);
    }
    return edges;
}

/// Normal of each triangle times its area [m2].
Eigen::Matrix3Xd area_vectors(const SurfaceMesh& surface) {
    Eigen::Matrix3Xd vectors(3, surface.triangles.cols());
    for (Eigen::Index t = 0; t < vectors.cols(); ++t) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, surface.triangles.col(t));
        vectors.col(t) = 0.5 * (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0));
    }
    return vectors;
}

/// Per triangle: whether its flat face is broad.
std::vector<bool> in_broad_face(const SurfaceMesh& surface, const Eigen::Matrix3Xd& areas,
                                const std::vector<SharedEdge>& edges, DisjointSets& faces, double edge) {
    const auto count = static_cast<std::size_t>(surface.triangles.cols());
    const auto face_of = [&](int t) { return faces.find(static_cast<std::size_t>(t)); };
    std::vector<double> area(count, 0.0), around(count, 0.0);
    for (int t = 0; t < surface.triangles.cols(); ++t) area[face_of(t)] += areas.col(t).norm();
    for (const SharedEdge& e : edges) {
        if (face_of(e.first) == face_of(e.second)) continue;
        const double length = (surface.vertices.col(e.low) - surface.vertices.col(e.high)).norm();
        around[face_of(e.first)] += length;
        around[face_of(e.second)] += length;
    }
    std::vector<bool> broad(count);
    for (std::size_t t = 0; t < count; ++t) {
        const std::size_t f = faces.find(t);
        broad[t] = 4.0 * area[f] >= feature_policy.face_breadth * edge * around[f];
    }
    return broad;
}

using LineEnds = std::map<int, std::vector<int>>;  // neighbours of each vertex along the lines

/// Vertices where a line ends, forks or bends.
std::set<int> ends_and_bends(const SurfaceMesh& surface, const LineEnds& neighbours) {
    std::set<int> corners;
    const double straight = std::cos(feature_policy.bend_deg * std::numbers::pi / 180.0);
    for (const auto& line : neighbours) {
        const int v = line.first;
        const std::vector<int>& others = line.second;
        const auto to = [&](std::size_t i) -> Eigen::Vector3d {
            return (surface.vertices.col(others[i]) - surface.vertices.col(v)).normalized();
        };
        if (others.size() != 2 || -to(0).dot(to(1)) < straight) corners.insert(v);
    }
    return corners;
}

/// Adds the vertices of a chain without which it would be off by more than `deviation` (Douglas & Peucker 1973).
void add_knots(const SurfaceMesh& surface, const std::vector<int>& chain, std::size_t first, std::size_t last,
               double deviation, std::set<int>& corners) {
    const Eigen::Vector3d start = surface.vertices.col(chain[first]), end = surface.vertices.col(chain[last]);
    std::size_t farthest = first;
    double most = deviation;
    for (std::size_t i = first + 1; i < last; ++i) {
        const Eigen::Vector3d x = surface.vertices.col(chain[i]);
        const double distance = (x - nearest_in_segment(start, end, x)).norm();
        if (distance > most) most = distance, farthest = i;
    }
    if (farthest == first) return;
    corners.insert(chain[farthest]);
    add_knots(surface, chain, first, farthest, deviation, corners);
    add_knots(surface, chain, farthest, last, deviation, corners);
}

/// Vertices along a line from `start` by `next` to the next corner, or round to the start.
std::vector<int> chain_from(int start, int next, const LineEnds& neighbours, const std::set<int>& corners) {
    std::vector<int> chain{start, next};
    while (chain.back() != start && !corners.contains(chain.back())) {
        const std::vector<int>& ends = neighbours.at(chain.back());
        chain.push_back(ends[0] == chain[chain.size() - 2] ? ends[1] : ends[0]);
    }
    return chain;
}

/// Vertices that stay: ends, forks and bends of lines, and what bounds the deviation of bent lines.
std::vector<int> corners_of(const SurfaceMesh& surface, const std::vector<std::pair<int, int>>& lines,
                            double deviation) {
    LineEnds neighbours;
    for (const auto& [a, b] : lines) neighbours[a].push_back(b), neighbours[b].push_back(a);
    std::set<int> corners = ends_and_bends(surface, neighbours);
    // Lines are divided at their true corners only: knots that are added on one line must not divide another.
    const std::set<int> fixed = corners;
    std::set<int> seen;
    // Chains between corners are visited from both ends.
    const auto visit = [&](int start, int next) {
        const std::vector<int> chain = chain_from(start, next, neighbours, fixed);
        seen.insert(chain.begin(), chain.end());
        add_knots(surface, chain, 0, chain.size() - 1, deviation, corners);
    };
    for (const int corner : fixed)
        for (const int next : neighbours.at(corner)) visit(corner, next);
    // Closed lines without corners.
    for (const auto& [v, others] : neighbours)
        if (!seen.contains(v)) corners.insert(v), visit(v, others[0]);
    return {corners.begin(), corners.end()};
}

}  // namespace

FeatureLines feature_lines(const SurfaceMesh& surface, double edge, double deviation) {
    const Eigen::Matrix3Xd areas = area_vectors(surface);
    const std::vector<SharedEdge> edges = shared_edges(surface, areas);
    DisjointSets faces(static_cast<std::size_t>(surface.triangles.cols()));
    for (const SharedEdge& e : edges)
        if (e.turn_deg <= feature_policy.flat_deg)
            faces.join(static_cast<std::size_t>(e.first), static_cast<std::size_t>(e.second));
    const std::vector<bool> broad = in_broad_face(surface, areas, edges, faces, edge);
    FeatureLines lines;
    for (const SharedEdge& e : edges) {
        const auto first = static_cast<std::size_t>(e.first), second = static_cast<std::size_t>(e.second);
        // Edges within a flat face are no feature, and narrow flat faces are facets of a round.
        const bool contour = faces.find(first) != faces.find(second) && (broad[first] || broad[second]);
        if (contour || e.turn_deg > feature_policy.sharp_deg) lines.edges.emplace_back(e.low, e.high);
    }
    lines.corners = corners_of(surface, lines.edges, deviation);
    return lines;
}

}  // namespace myo::mesh
