#include "mesh/contour_fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace myo::mesh {
namespace {

using Loop = std::vector<int>;
using Point2 = Eigen::Vector2d;
using ContourEdge = std::pair<int, int>;

// Contours in plane coordinates. Areas below `flat` count as zero: collinear points are collinear only up to rounding.
struct PlaneView {
    std::vector<Point2> points;
    double flat = 0.0;

    const Point2& operator[](int v) const { return points[static_cast<std::size_t>(v)]; }
    // Twice the signed area of a triangle, positive for a left turn.
    double turn(int a, int b, int c) const {
        const Point2 u = (*this)[b] - (*this)[a], v = (*this)[c] - (*this)[a];
        return u[0] * v[1] - u[1] * v[0];
    }
    // Signed area of a loop, positive if it runs counter-clockwise.
    double area(const Loop& loop) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < loop.size(); ++i) sum += 0.5 * turn(loop[0], loop[i], loop[(i + 1) % loop.size()]);
        return sum;
    }
};

/// Projection along the dominant axis of the normal, with the orientation preserved.
PlaneView view_along(const Eigen::Matrix3Xd& vertices, const Eigen::Vector3d& normal) {
    Eigen::Index drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    PlaneView view;
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
        view.points.emplace_back(vertices((drop + 1) % 3, v), vertices((drop + 2) % 3, v));
        // Swapping the axes keeps left turns left for a negative normal.
        if (normal[drop] < 0.0) std::swap(view.points.back()[0], view.points.back()[1]);
        low = low.min(view.points.back().array()), high = high.max(view.points.back().array());
    }
    // Relative to the extent of the contours: rounding of products of coordinates.
    view.flat = 1e-12 * (high - low).square().sum();
    return view;
}

// If several edges leave a vertex, the leftmost one continues the loop around the same region.
std::size_t next_edge(const PlaneView& view, const std::vector<ContourEdge>& edges, const ContourEdge& last,
                      const std::vector<bool>& used) {
    std::size_t best = edges.size();
    double most = -4.0;
    const Point2 along = view[last.second] - view[last.first];
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (used[e] || edges[e].first != last.second) continue;
        const Point2 d = view[edges[e].second] - view[edges[e].first];
        // Turning angle from the last edge, positive to the left.
        const double angle = std::atan2(along[0] * d[1] - along[1] * d[0], along.dot(d));
        if (angle > most) most = angle, best = e;
    }
    return best;
}

/// Splits directed edges into closed loops; empty if a loop does not close.
std::optional<std::vector<Loop>> loops_of(const PlaneView& view, const std::vector<ContourEdge>& edges) {
    std::vector<Loop> loops;
    std::vector<bool> used(edges.size(), false);
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (used[first]) continue;
        Loop loop;
        for (std::size_t e = first;;) {
            used[e] = true;
            loop.push_back(edges[e].first);
            // Closed at its first vertex.
            if (edges[e].second == edges[first].first) break;
            e = next_edge(view, edges, edges[e], used);
            if (e == edges.size()) return std::nullopt;
        }
        // An edge and its reverse enclose nothing.
        if (loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
}

// True if the segment p-q meets a side of the loop other than at its own end points.
bool meets(const PlaneView& view, const Loop& loop, int p, int q) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        // A vertex in the interior of the segment counts as an intersection.
        if (a != p && a != q && std::abs(view.turn(p, q, a)) <= view.flat &&
            (view[a] - view[p]).dot(view[a] - view[q]) < 0.0)
            return true;
        if (a == p || a == q || b == p || b == q) continue;
        if ((view.turn(p, q, a) > 0.0) != (view.turn(p, q, b) > 0.0) &&
            (view.turn(a, b, p) > 0.0) != (view.turn(a, b, q) > 0.0))
            return true;
    }
    return false;
}

/// Even-odd rule for a point and a loop.
bool contains_point(const PlaneView& view, const Loop& loop, const Point2& x) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2 &a = view[loop[i]], &b = view[loop[(i + 1) % loop.size()]];
        if ((a[1] > x[1]) == (b[1] > x[1])) continue;
        if (x[0] < a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
}

// Whether a segment from the i-th vertex of a loop to q begins on the left of the loop. A vertex from which bridges
// start stands in the loop several times, and each time the loop turns by another angle.
// Source: O'Rourke, Computational Geometry in C, 1998, 1.6.3 (InCone).
bool begins_inside(const PlaneView& view, const Loop& loop, std::size_t i, int q) {
    const int before = loop[(i + loop.size() - 1) % loop.size()], p = loop[i], after = loop[(i + 1) % loop.size()];
    if (view.turn(before, p, after) >= 0.0) return view.turn(p, q, before) > 0.0 && view.turn(q, p, after) > 0.0;
    return !(view.turn(p, q, after) >= 0.0 && view.turn(q, p, before) >= 0.0);
}

// Joins the nearest hole with the outer loop by a bridge that is traversed in both directions. The bridge must not
// cross any loop.
bool join_a_hole(const PlaneView& view, Loop& outer, std::vector<Loop>& holes) {
    struct Bridge {
        double squared_length;
        std::size_t hole, from, to;
    };
    std::vector<Bridge> bridges;
    for (std::size_t h = 0; h < holes.size(); ++h)
        for (std::size_t i = 0; i < outer.size(); ++i)
            for (std::size_t j = 0; j < holes[h].size(); ++j)
                bridges.push_back({(view[outer[i]] - view[holes[h][j]]).squaredNorm(), h, i, j});
    // Shortest bridges first: they cross the fewest loops and give well-shaped triangles.
    std::sort(bridges.begin(), bridges.end(),
              [](const Bridge& a, const Bridge& b) { return a.squared_length < b.squared_length; });
    for (const Bridge& bridge : bridges) {
        const int p = outer[bridge.from], q = holes[bridge.hole][bridge.to];
        if (!begins_inside(view, outer, bridge.from, q) || meets(view, outer, p, q)) continue;
        if (std::any_of(holes.begin(), holes.end(), [&](const Loop& hole) { return meets(view, hole, p, q); }))
            continue;
        // The hole is inserted into the outer loop: across the bridge, around the hole and back.
        Loop detour = holes[bridge.hole];
        std::rotate(detour.begin(), detour.begin() + static_cast<std::ptrdiff_t>(bridge.to), detour.end());
        detour.push_back(q);
        detour.push_back(p);
        outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(bridge.from) + 1, detour.begin(), detour.end());
        holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(bridge.hole));
        return true;
    }
    return false;
}

// Shape of a triangle: 1 if equilateral, 0 if degenerate.
double triangle_shape(const PlaneView& view, int a, int b, int c) {
    const double squares = (view[a] - view[b]).squaredNorm() + (view[b] - view[c]).squaredNorm() +
                           (view[c] - view[a]).squaredNorm();
    return 2.0 * std::sqrt(3.0) * view.turn(a, b, c) / squares;
}

// Ear clipping, best-shaped ear first. False if there is no ear: the loop crosses itself.
bool cut_ears(const PlaneView& view, Loop rest, std::vector<std::array<int, 3>>& triangles) {
    while (rest.size() > 2) {
        std::size_t best = rest.size();
        double best_shape = 0.0;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            const int a = rest[(i + rest.size() - 1) % rest.size()], b = rest[i], c = rest[(i + 1) % rest.size()];
            if (view.turn(a, b, c) <= view.flat) continue;
            const double shape = triangle_shape(view, a, b, c);
            if (shape <= best_shape) continue;
            // An ear must not contain other vertices of the loop, boundary included.
            const bool empty = std::none_of(rest.begin(), rest.end(), [&](int p) {
                return p != a && p != b && p != c && view.turn(a, b, p) >= -view.flat &&
                       view.turn(b, c, p) >= -view.flat && view.turn(c, a, p) >= -view.flat;
            });
            if (empty) best = i, best_shape = shape;
        }
        if (best == rest.size()) return false;
        triangles.push_back({rest[(best + rest.size() - 1) % rest.size()], rest[best], rest[(best + 1) % rest.size()]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return true;
}

// Each contour edge belongs to one triangle and each other edge to two.
bool fits(const std::vector<std::array<int, 3>>& triangles, const std::vector<ContourEdge>& edges) {
    // Each directed edge may occur only once; inner edges occur in both directions.
    std::set<ContourEdge> open;
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (!open.insert({t[i], t[(i + 1) % 3]}).second) return false;
    for (const ContourEdge& edge : edges)
        if (open.erase(edge) == 0) return false;
    return std::all_of(open.begin(), open.end(), [&](const ContourEdge& e) {
        return open.contains({e.second, e.first});
    });
}

}  // namespace

Result<std::vector<std::array<int, 3>>> fill_contours(const Eigen::Matrix3Xd& vertices,
                                                      const std::vector<ContourEdge>& edges,
                                                      const Eigen::Vector3d& normal) {
    const Error broken{"a section has contours that are open or cross", ""};
    std::vector<std::array<int, 3>> triangles;
    if (edges.empty()) return triangles;
    const PlaneView view = view_along(vertices, normal);
    std::optional<std::vector<Loop>> loops = loops_of(view, edges);
    if (!loops) return broken;
    // Outer loops have positive area, holes negative area.
    const auto first_hole = std::stable_partition(loops->begin(), loops->end(),
                                                  [&](const Loop& loop) { return view.area(loop) > 0.0; });
    std::vector<Loop> outers(loops->begin(), first_hole), all_holes(first_hole, loops->end());
    // Loops are processed by ascending area: a hole belongs to the smallest loop that contains it.
    std::sort(outers.begin(), outers.end(), [&](const Loop& a, const Loop& b) { return view.area(a) < view.area(b); });
    for (Loop& outer : outers) {
        std::vector<Loop> holes;
        std::erase_if(all_holes, [&](const Loop& hole) {
            const bool own = contains_point(view, outer, 0.5 * (view[hole[0]] + view[hole[1]]));
            if (own) holes.push_back(hole);
            return own;
        });
        while (!holes.empty())
            if (!join_a_hole(view, outer, holes)) return broken;
        if (!cut_ears(view, outer, triangles)) return broken;
    }
    // Final check of the topology for arbitrary contours.
    if (!all_holes.empty() || !fits(triangles, edges)) return broken;
    return triangles;
}

}  // namespace myo::mesh
