#include "mesh/short_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>

namespace myo::mesh {
namespace {

using TriangleCorners = std::array<int, 3>;

/// Edge collapse restricted to vertices that stay on their planes.
class EdgeCollapse {
public:
    EdgeCollapse(const SurfaceMesh& surface, const GridPlanes& planes, double edge)
        : x_(surface.vertices), edge_(edge), star_(static_cast<std::size_t>(surface.vertices.cols())) {
        for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
            triangles_.push_back({surface.triangles(0, t), surface.triangles(1, t), surface.triangles(2, t)});
            for (const int v : triangles_.back()) star_[static_cast<std::size_t>(v)].push_back(static_cast<int>(t));
        }
        for (Eigen::Index v = 0; v < x_.cols(); ++v) {
            std::array<int, 3> on{-1, -1, -1};
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t p = 0; p < planes[a].size(); ++p)
                    // Exact comparison: cutting and snapping set the coordinate of the plane exactly.
                    if (x_(static_cast<Eigen::Index>(a), v) == planes[a][p]) on[a] = static_cast<int>(p);
            on_.push_back(on);
        }
    }

    /// One pass over the short edges, shortest first.
    /// @param deviation  largest displacement of a triangle along its normal [m]
    /// @return           true if anything changed
    bool round(double deviation) {
        std::vector<std::tuple<double, int, int>> candidates;
        for (std::size_t u = 0; u < star_.size(); ++u) {
            // Targets are vertices on planes: only there has cutting created short edges.
            if (on_[u] == std::array{-1, -1, -1}) continue;
            for (const int v : neighbours(static_cast<int>(u)))
                if (may_join(v, static_cast<int>(u)))
                    candidates.emplace_back(length(v, static_cast<int>(u)), v, static_cast<int>(u));
        }
        std::sort(candidates.begin(), candidates.end());
        bool changed = false;
        for (const auto& [l, v, u] : candidates) {
            // Earlier collapses of this pass may have changed the neighbourhood.
            const std::vector<int> near = neighbours(u);
            if (std::find(near.begin(), near.end(), v) == near.end() || !may_join(v, u) ||
                !keeps_shape(v, u, deviation))
                continue;
            join(v, u);
            changed = true;
        }
        return changed;
    }

    // Surface after the collapses; removed triangles are marked by -1.
    SurfaceMesh result() const {
        SurfaceMesh surface{x_, {}};
        surface.triangles.resize(
            3, std::count_if(triangles_.begin(), triangles_.end(), [](const TriangleCorners& t) { return t[0] >= 0; }));
        Eigen::Index column = 0;
        for (const TriangleCorners& t : triangles_)
            if (t[0] >= 0) surface.triangles.col(column++) << t[0], t[1], t[2];
        return surface;
    }

private:
    Eigen::Vector3d at(int v) const { return x_.col(v); }
    double length(int a, int b) const { return (at(a) - at(b)).norm(); }
    const std::vector<int>& star(int v) const { return star_[static_cast<std::size_t>(v)]; }
    TriangleCorners& triangle(int t) { return triangles_[static_cast<std::size_t>(t)]; }
    const TriangleCorners& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
    bool has(int t, int v) const { return std::find(triangle(t).begin(), triangle(t).end(), v) != triangle(t).end(); }

    // Vertices connected to v by an edge, ascending.
    std::vector<int> neighbours(int v) const {
        std::vector<int> found;
        for (const int t : star(v))
            for (const int w : triangle(t))
                if (w != v) found.push_back(w);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    // True if v may move to u: u lies on all planes of v, and the edge is short.
    bool may_join(int v, int u) const {
        const auto &on_v = on_[static_cast<std::size_t>(v)], &on_u = on_[static_cast<std::size_t>(u)];
        for (std::size_t a = 0; a < 3; ++a)
            // A vertex may not leave any of its planes.
            if (on_v[a] >= 0 && on_v[a] != on_u[a]) return false;
        double longest = 0.0;
        for (const int w : neighbours(v)) longest = std::max(longest, length(v, w));
        return length(v, u) < 0.5 * std::min(edge_, longest);
    }

    /// True if the collapse changes neither topology nor, beyond the deviation, geometry.
    bool keeps_shape(int v, int u, double deviation) const {
        // Link condition: both ends share exactly the two vertices opposite to the edge, otherwise the surface would
        // become non-manifold.
        const std::vector<int> near_v = neighbours(v), near_u = neighbours(u);
        std::vector<int> common;
        std::set_intersection(near_v.begin(), near_v.end(), near_u.begin(), near_u.end(), std::back_inserter(common));
        if (common.size() != 2) return false;
        const Eigen::Vector3d step = at(u) - at(v);
        for (const int t : star(v)) {
            if (has(t, u)) continue;
            const auto normal = [&](bool moved) {
                std::array<Eigen::Vector3d, 3> p;
                for (std::size_t i = 0; i < 3; ++i) p[i] = moved && triangle(t)[i] == v ? at(u) : at(triangle(t)[i]);
                return Eigen::Vector3d((p[1] - p[0]).cross(p[2] - p[0]));
            };
            const Eigen::Vector3d before = normal(false), after = normal(true);
            // A triangle without area has no normal along which its displacement could be limited.
            if (!(before.norm() > 0.0) || std::abs(before.dot(step)) > deviation * before.norm()) return false;
            // 0.87: normals turn by less than 30 degrees; 1e-6: no triangle degenerates to a line.
            if (!(before.dot(after) > 0.87 * before.norm() * after.norm()) || after.norm() < 1e-6 * before.norm())
                return false;
        }
        return true;
    }

    /// Moves v to u and removes the triangles of their edge.
    void join(int v, int u) {
        for (const int t : std::vector<int>(star(v))) {
            // Triangles of the collapsed edge lose their area; all others of v get the corner u.
            if (has(t, u)) {
                for (const int w : TriangleCorners(triangle(t))) std::erase(star_[static_cast<std::size_t>(w)], t);
                triangle(t) = {-1, -1, -1};
            } else {
                std::replace(triangle(t).begin(), triangle(t).end(), v, u);
                star_[static_cast<std::size_t>(u)].push_back(t);
            }
        }
        star_[static_cast<std::size_t>(v)].clear();
    }

    Eigen::Matrix3Xd x_;
    double edge_;
    std::vector<TriangleCorners> triangles_;
    std::vector<std::vector<int>> star_;  // triangles around each vertex
    std::vector<std::array<int, 3>> on_;  // plane of each axis on which a vertex lies; -1: none
};

// Removes vertices without triangles.
SurfaceMesh without_unused_vertices(const SurfaceMesh& surface) {
    std::vector<int> number(static_cast<std::size_t>(surface.vertices.cols()), -1);
    for (const int v : surface.triangles.reshaped()) number[static_cast<std::size_t>(v)] = 0;
    // Vertices keep their order.
    std::vector<Eigen::Index> used;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] == 0) number[v] = static_cast<int>(used.size()), used.push_back(static_cast<Eigen::Index>(v));
    return {surface.vertices(Eigen::all, used),
            surface.triangles.unaryExpr([&](int v) { return number[static_cast<std::size_t>(v)]; })};
}

}  // namespace

SurfaceMesh without_short_edges(const SurfaceMesh& surface, const GridPlanes& planes, double edge, double deviation) {
    EdgeCollapse collapse(surface, planes, edge);
    // First only collapses that do not change the shape, which leave corners and creases in place. The number of passes
    // is limited to bound the time; a few are sufficient.
    for (const double allowed : {1e-6 * deviation, deviation})
        for (int round = 0; round < 8 && collapse.round(allowed);) ++round;
    return without_unused_vertices(collapse.result());
}

}  // namespace myo::mesh
