#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/box_tree.hpp"
#include "mesh/surface_check.hpp"

namespace myo::mesh {
namespace {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Triangle = std::array<Vector3, 3>;

/// Plane of a triangle.
struct Plane {
    Vector3 normal;  // unit; zero for a triangle without area
    double offset;
    /// Signed distance of a point.
    double depth(const Vector3& x) const { return normal.dot(x) - offset; }
};

/// Plane of a triangle, oriented by its corners.
Plane plane_of(const Triangle& t) {
    const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double length = n.norm();
    const Vector3 unit = length > 0.0 ? Vector3(n / length) : Vector3::Zero();
    return {unit, unit.dot(t[0])};
}

/// True if the projection of x along the normal lies in the triangle.
bool inside(const Triangle& t, const Vector3& normal, const Vector3& x) {
    for (std::size_t i = 0; i < 3; ++i) {
        if ((t[(i + 1) % 3] - t[i]).cross(x - t[i]).dot(normal) < 0.0) return false;
    }
    return true;
}

// True if an edge of `a` passes through `b`: end points clearly on opposite sides, intersection point inside.
bool pierces(const Triangle& a, const Triangle& b, const Plane& plane, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 &p = a[i], &q = a[(i + 1) % 3];
        const double dp = plane.depth(p), dq = plane.depth(q);
        // Contact within the tolerance is not an intersection: neighbours share vertices and edges.
        if (std::min(dp, dq) >= -tolerance || std::max(dp, dq) <= tolerance) continue;
        if (inside(b, plane.normal, p + (q - p) * (dp / (dp - dq)))) return true;
    }
    return false;
}

/// z component of the cross product.
double cross2(const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Area of a plane convex polygon, without sign.
double area(const std::vector<Vector2>& polygon) {
    double sum = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross2(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * std::abs(sum);
}

// Common area of two coplanar triangles, by clipping one with the sides of the other.
double shared_area(const Triangle& a, const Triangle& b, const Vector3& normal) {
    // Projection along the dominant axis; the area is corrected by the normal at the end.
    Eigen::Index drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const auto flat = [&](const Vector3& x) { return Vector2(x[(drop + 1) % 3], x[(drop + 2) % 3]); };
    std::array<Vector2, 3> knife{flat(b[0]), flat(b[1]), flat(b[2])};
    if (cross2(knife[1] - knife[0], knife[2] - knife[0]) < 0.0) std::swap(knife[1], knife[2]);
    std::vector<Vector2> polygon{flat(a[0]), flat(a[1]), flat(a[2])};
    for (std::size_t s = 0; s < 3 && !polygon.empty(); ++s) {
        const Vector2 from = knife[s], along = knife[(s + 1) % 3] - from;
        std::vector<Vector2> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const double dp = cross2(along, p - from), dq = cross2(along, q - from);
            if (dp >= 0.0) kept.push_back(p);
            if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) kept.push_back(p + (q - p) * (dp / (dp - dq)));
        }
        polygon = std::move(kept);
    }
    return area(polygon) / std::abs(normal[drop]);
}

double area(const Triangle& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm(); }

/// Whether two triangles cross, or overlap in a common plane; contact within the tolerance [m] does not count.
bool intersect(const Triangle& a, const Plane& A, const Triangle& b, const Plane& B, double tolerance) {
    // A triangle without area has no plane.
    if (A.normal.isZero(0.0) || B.normal.isZero(0.0)) return false;
    const auto away = [&](const Plane& plane, const Triangle& t) {
        return std::max({std::abs(plane.depth(t[0])), std::abs(plane.depth(t[1])), std::abs(plane.depth(t[2]))});
    };
    // Both lie in one plane: they intersect if they share an area.
    if (away(A, b) <= tolerance && away(B, a) <= tolerance) {
        // Neighbours in one plane share no area; a thousandth allows for rounding.
        return shared_area(a, b, A.normal) > 1e-3 * std::min(area(a), area(b));
    }
    // Two triangles in general position intersect if and only if an edge of one passes through the other.
    return pierces(a, b, B, tolerance) || pierces(b, a, A, tolerance);
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const SurfaceMesh& surface, double tolerance) {
    const auto count = static_cast<std::size_t>(surface.triangles.cols());
    std::vector<Triangle> triangles(count);
    std::vector<Plane> planes(count);
    std::vector<Box> boxes(count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            triangles[t][i] = surface.vertices.col(
                surface.triangles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(t)));
        }
        planes[t] = plane_of(triangles[t]);
        boxes[t] = {triangles[t][0].cwiseMin(triangles[t][1]).cwiseMin(triangles[t][2]),
                    triangles[t][0].cwiseMax(triangles[t][1]).cwiseMax(triangles[t][2])};
    }
    std::vector<std::pair<int, int>> found;
    BoxTree(boxes).overlapping_pairs(tolerance, [&](int p, int q) {
        const auto a = static_cast<std::size_t>(p), b = static_cast<std::size_t>(q);
        if (intersect(triangles[a], planes[a], triangles[b], planes[b], tolerance)) found.emplace_back(p, q);
        return true;
    });
    // The tree visits pairs in its own order.
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace myo::mesh
