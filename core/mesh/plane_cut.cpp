#include "mesh/plane_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace myo::mesh {
namespace {

using EdgeKey = std::pair<int, int>;

/// Undirected edge, lower vertex first.
EdgeKey edge_key(int a, int b) { return std::minmax(a, b); }

/// Intersection of the edge a-b with the plane, which lies between its ends.
Eigen::Vector3d point_on_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const AxisPlane& plane) {
    const double t = (plane.at - a[plane.axis]) / (b[plane.axis] - a[plane.axis]);
    // Equal coordinates stay equal, so a vertex on another plane remains on it.
    Eigen::Vector3d x = a + t * (b - a);
    x[plane.axis] = plane.at;
    return x;
}

// Cuts all triangles by a plane. The new vertex of an edge is shared by both of its triangles.
class PlaneCutter {
public:
    PlaneCutter(const SurfaceMesh& surface, const AxisPlane& plane, const Box& where) : plane_(plane) {
        for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v) points_.push_back(surface.vertices.col(v));
        // Two passes: vertices on shared edges must exist before any triangle is split.
        for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) mark_crossings(surface.triangles.col(t), where);
        for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) split(surface.triangles.col(t));
    }

    SurfaceMesh result() const {
        SurfaceMesh cut;
        cut.vertices.resize(3, static_cast<Eigen::Index>(points_.size()));
        for (std::size_t v = 0; v < points_.size(); ++v) cut.vertices.col(static_cast<Eigen::Index>(v)) = points_[v];
        cut.triangles.resize(3, static_cast<Eigen::Index>(triangles_.size()));
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            cut.triangles.col(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
        return cut;
    }

private:
    /// Signed distance of a vertex to the plane.
    double side(int v) const { return points_[static_cast<std::size_t>(v)][plane_.axis] - plane_.at; }
    bool crosses(int a, int b) const { return (side(a) < 0.0 && side(b) > 0.0) || (side(a) > 0.0 && side(b) < 0.0); }

    /// Adds vertices on the crossed edges of a triangle, if the intersection reaches into `where`.
    void mark_crossings(const Eigen::Vector3i& t, const Box& where) {
        Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
        bool crossed = false;
        for (int i = 0; i < 3; ++i) {
            // Bounds of the intersection line: crossings of edges, and corners in the plane.
            const auto [a, b] = edge_key(t[i], t[(i + 1) % 3]);
            Eigen::Vector3d x = points_[static_cast<std::size_t>(t[i])];
            if (crosses(a, b))
                x = point_on_plane(points_[static_cast<std::size_t>(a)], points_[static_cast<std::size_t>(b)], plane_);
            else if (side(t[i]) != 0.0)
                continue;
            crossed = crossed || crosses(a, b);
            low = low.min(x.array()), high = high.max(x.array());
        }
        if (!crossed || (high < where.lowest.array()).any() || (low > where.highest.array()).any()) return;
        for (int i = 0; i < 3; ++i) {
            const EdgeKey edge = edge_key(t[i], t[(i + 1) % 3]);
            // The vertex is computed from the ordered edge, so both triangles get identical coordinates.
            if (!crosses(edge.first, edge.second) || added_.contains(edge)) continue;
            added_[edge] = static_cast<int>(points_.size());
            points_.push_back(point_on_plane(points_[static_cast<std::size_t>(edge.first)],
                                             points_[static_cast<std::size_t>(edge.second)], plane_));
        }
    }

    /// Vertex added on an edge; -1 if there is none.
    int added_on(int a, int b) const {
        const auto found = added_.find(edge_key(a, b));
        return found == added_.end() ? -1 : found->second;
    }

    double length(int a, int b) const {
        return (points_[static_cast<std::size_t>(a)] - points_[static_cast<std::size_t>(b)]).norm();
    }

    /// Splits a triangle at the vertices added on its edges: at two edges into three triangles, at one edge into two.
    void split(const Eigen::Vector3i& t) {
        for (int i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            const int m = added_on(a, b), n = added_on(a, c);
            if (m >= 0 && n >= 0) {  // the corner `a` is cut off; the rest is a quadrilateral
                triangles_.push_back({a, m, n});
                // The shorter diagonal gives better triangles.
                if (length(m, c) < length(b, n))
                    triangles_.insert(triangles_.end(), {{m, b, c}, {m, c, n}});
                else
                    triangles_.insert(triangles_.end(), {{m, b, n}, {b, c, n}});
                return;
            }
        }
        for (int i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            if (const int m = added_on(a, b); m >= 0) {
                triangles_.insert(triangles_.end(), {{a, m, c}, {m, b, c}});
                return;
            }
        }
        triangles_.push_back({t[0], t[1], t[2]});
    }

    AxisPlane plane_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<std::array<int, 3>> triangles_;
    std::map<EdgeKey, int> added_;
};

}  // namespace

SurfaceMesh cut_by_plane(const SurfaceMesh& surface, const AxisPlane& plane, const Box& where) {
    return PlaneCutter(surface, plane, where).result();
}

SurfaceMesh snapped_to_plane(SurfaceMesh surface, const AxisPlane& plane, double distance) {
    // The limit by the shortest edge prevents flipped triangles.
    Eigen::VectorXd shortest = Eigen::VectorXd::Constant(surface.vertices.cols(),
                                                         std::numeric_limits<double>::infinity());
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int a = surface.triangles(i, t), b = surface.triangles((i + 1) % 3, t);
            const double length = (surface.vertices.col(a) - surface.vertices.col(b)).norm();
            shortest[a] = std::min(shortest[a], length), shortest[b] = std::min(shortest[b], length);
        }
    for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v)
        if (std::abs(surface.vertices(plane.axis, v) - plane.at) <= std::min(distance, 0.1 * shortest[v]))
            surface.vertices(plane.axis, v) = plane.at;
    return surface;
}

}  // namespace myo::mesh
