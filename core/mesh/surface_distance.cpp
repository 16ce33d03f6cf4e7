#include "mesh/surface_distance.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

namespace myo::mesh {
namespace {

/// Bounding box of each triangle [m].
std::vector<Box> boxes_of_triangles(const SurfaceMesh& surface) {
    std::vector<Box> boxes;
    boxes.reserve(static_cast<std::size_t>(surface.triangles.cols()));
    for (const auto& t : surface.triangles.colwise()) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, t);
        boxes.push_back({X.rowwise().minCoeff(), X.rowwise().maxCoeff()});
    }
    return boxes;
}

}  // namespace

Eigen::Vector3d nearest_in_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& point) {
    const Eigen::Vector3d ab = b - a;
    const double squared_length = ab.squaredNorm();
    return squared_length > 0.0 ? a + std::clamp(ab.dot(point - a) / squared_length, 0.0, 1.0) * ab : a;
}

Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                    const Eigen::Vector3d& point) {
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    // Below the rounding of its normal a triangle has no inside, and the signs of the regions below mean nothing.
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    if (ab.cross(ac).squaredNorm() <= rounding * rounding * ab.squaredNorm() * ac.squaredNorm()) {
        const std::array sides{nearest_in_segment(a, b, point), nearest_in_segment(b, c, point),
                               nearest_in_segment(c, a, point)};
        return *std::min_element(sides.begin(), sides.end(), [&](const auto& x, const auto& y) {
            return (x - point).squaredNorm() < (y - point).squaredNorm();
        });
    }
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    // Voronoi regions of the corners, then of the sides; what remains projects into the triangle.
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    if (d3 >= 0.0 && d4 <= d3) return b;
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double of_c = d1 * d4 - d3 * d2, of_b = d5 * d2 - d1 * d6, of_a = d3 * d6 - d5 * d4;
    if (of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    if (of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    if (of_a <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + (of_b * ab + of_c * ac) / (of_a + of_b + of_c);
}

SurfaceDistance::SurfaceDistance(const SurfaceMesh& surface) : surface_(surface), tree_(boxes_of_triangles(surface)) {}

Eigen::Vector3d SurfaceDistance::nearest_on(int triangle, const Eigen::Vector3d& point) const {
    const auto t = surface_.triangles.col(triangle);
    return nearest_in_triangle(surface_.vertices.col(t[0]), surface_.vertices.col(t[1]), surface_.vertices.col(t[2]),
                               point);
}

SurfaceDistance::Nearest SurfaceDistance::nearest(const Eigen::Vector3d& point) const {
    Nearest result;
    result.triangle = tree_.nearest(point, [&](int t) { return (nearest_on(t, point) - point).squaredNorm(); });
    if (result.triangle < 0) return result;
    result.point = nearest_on(result.triangle, point);
    result.distance = (result.point - point).norm();
    return result;
}

double SurfaceDistance::largest_from(const SurfaceMesh& other) const {
    double largest = 0.0;
    const auto measure = [&](const Eigen::Vector3d& x) { largest = std::max(largest, nearest(x).distance); };
    for (const auto& x : other.vertices.colwise()) measure(x);
    for (const auto& t : other.triangles.colwise()) {
        const Eigen::Matrix3d X = other.vertices(Eigen::all, t);
        measure(X.rowwise().mean());
        // Each side belongs to two triangles of a closed surface.
        for (int i = 0; i < 3; ++i)
            if (t[i] < t[(i + 1) % 3]) measure(0.5 * (X.col(i) + X.col((i + 1) % 3)));
    }
    return largest;
}

}  // namespace myo::mesh
