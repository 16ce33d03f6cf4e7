#include "mesh/clipping.hpp"

#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace myo::mesh {
namespace {

using Corners = Eigen::Matrix<double, 3, 4>;

// Signed distance to a side of the box, positive inside, set to zero within the tolerance.
double depth(const Eigen::Vector3d& x, const Box& box, int side, double tolerance) {
    const int axis = side / 2;
    const double d = side % 2 == 0 ? x[axis] - box.lowest[axis] : box.highest[axis] - x[axis];
    return std::abs(d) <= tolerance ? 0.0 : d;
}

/// Intersection of the segment a-b with a side, from the signed distances of its ends.
Eigen::Vector3d crossing(const Eigen::Vector3d& a, double depth_a, const Eigen::Vector3d& b, double depth_b) {
    return a + (b - a) * (depth_a / (depth_a - depth_b));
}

// Clips a tetrahedron by the remaining half-spaces recursively. Returns the integral of p p' with p = (1, x), which
// contains volume, first and second moments.
Eigen::Matrix4d moments_inside(const Corners& tet, const Box& box, int side, double tolerance) {
    // All sides done: exact moments of a tetrahedron, V/20 (sum p_i p_i' + (sum p_i)(sum p_i)').
    if (side == 6) {
        Eigen::Matrix3d J;
        for (int i = 0; i < 3; ++i) J.col(i) = tet.col(i + 1) - tet.col(0);
        const double volume = std::abs(J.determinant()) / 6.0;
        Eigen::Matrix4d p;
        p << Eigen::RowVector4d::Ones(), tet;
        const Eigen::Vector4d sum = p.rowwise().sum();
        return volume / 20.0 * (p * p.transpose() + sum * sum.transpose());
    }
    std::array<int, 4> inside{}, outside{};
    int n_inside = 0, n_outside = 0;
    std::array<double, 4> d{};
    for (int i = 0; i < 4; ++i) {
        const auto s = static_cast<std::size_t>(i);
        d[s] = depth(tet.col(i), box, side, tolerance);
        if (d[s] >= 0.0)
            inside[static_cast<std::size_t>(n_inside++)] = i;
        else
            outside[static_cast<std::size_t>(n_outside++)] = i;
    }
    if (n_outside == 0) return moments_inside(tet, box, side + 1, tolerance);
    if (n_inside == 0) return Eigen::Matrix4d::Zero();

    const auto cut = [&](int a, int b) {
        return crossing(tet.col(a), d[static_cast<std::size_t>(a)], tet.col(b), d[static_cast<std::size_t>(b)]);
    };
    const auto piece = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           const Eigen::Vector3d& e) -> Eigen::Matrix4d {
        Corners part;
        part << a, b, c, e;
        return moments_inside(part, box, side + 1, tolerance);
    };
    // A prism with triangles (a0 a1 a2) and (b0 b1 b2) is divided into three tetrahedra.
    const auto prism = [&](const std::array<Eigen::Vector3d, 3>& a,
                           const std::array<Eigen::Vector3d, 3>& b) -> Eigen::Matrix4d {
        return piece(a[0], a[1], a[2], b[2]) + piece(a[0], a[1], b[1], b[2]) + piece(a[0], b[0], b[1], b[2]);
    };
    // Cases by the number of corners inside: a tetrahedron, a prism below a triangle, a wedge between two edges.
    if (n_inside == 1) {
        const int p = inside[0];
        return piece(tet.col(p), cut(p, outside[0]), cut(p, outside[1]), cut(p, outside[2]));
    }
    if (n_inside == 3) {
        const int q = outside[0];
        return prism({tet.col(inside[0]), tet.col(inside[1]), tet.col(inside[2])},
                     {cut(inside[0], q), cut(inside[1], q), cut(inside[2], q)});
    }
    const int p = inside[0], q = inside[1];
    return prism({tet.col(p), cut(p, outside[0]), cut(p, outside[1])},
                 {tet.col(q), cut(q, outside[0]), cut(q, outside[1])});
}

}  // namespace

Polygon clip_to_box(Polygon polygon, const Box& box, double tolerance) {
    for (int side = 0; side < 6 && !polygon.empty(); ++side) {
        Polygon kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::Vector3d& a = polygon[i];
            const Eigen::Vector3d& b = polygon[(i + 1) % polygon.size()];
            const double depth_a = depth(a, box, side, tolerance), depth_b = depth(b, box, side, tolerance);
            // Sutherland-Hodgman: keep vertices inside, add the intersection of every crossing side.
            if (depth_a >= 0.0) kept.push_back(a);
            if ((depth_a > 0.0 && depth_b < 0.0) || (depth_a < 0.0 && depth_b > 0.0)) {
                kept.push_back(crossing(a, depth_a, b, depth_b));
            }
        }
        polygon = std::move(kept);
    }
    // Contact at a corner or along an edge leaves less than a polygon.
    if (polygon.size() < 3) polygon.clear();
    return polygon;
}

ClippedVolume tetrahedron_in_box(const Eigen::Matrix<double, 3, 4>& corners, const Box& box, double tolerance) {
    // Quick test by bounding boxes: most cells do not meet the box.
    if ((corners.rowwise().maxCoeff().array() <= box.lowest.array()).any() ||
        (corners.rowwise().minCoeff().array() >= box.highest.array()).any()) {
        return {};
    }
    const Eigen::Matrix4d moments = moments_inside(corners, box, 0, tolerance);
    return {moments(0, 0), moments.col(0).tail<3>(), moments.bottomRightCorner<3, 3>()};
}

}  // namespace myo::mesh
