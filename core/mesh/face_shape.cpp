#include "mesh/face_shape.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include <Eigen/Dense>

namespace myo::mesh {
namespace {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;

// Parameter of the point of segment a-b nearest to p, in [0, 1].
double segment_parameter(const Vector3& a, const Vector3& b, const Vector3& p) {
    const Vector3 d = b - a;
    const double squared_length = d.squaredNorm();
    return squared_length > 0.0 ? std::clamp(d.dot(p - a) / squared_length, 0.0, 1.0) : 0.0;
}

// Nearest point of a flat triangle as (u, v): the foot of the perpendicular if it is inside, otherwise the best point
// of the sides.
Vector2 triangle_parameters(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p) {
    const Vector3 e1 = b - a, e2 = c - a, r = p - a;
    const double g11 = e1.squaredNorm(), g12 = e1.dot(e2), g22 = e2.squaredNorm();
    // Normal equations of the projection on the plane of the triangle. Degenerate triangles use their sides only.
    const double determinant = g11 * g22 - g12 * g12;
    if (determinant > 1e-14 * g11 * g22) {
        const double u = (g22 * e1.dot(r) - g12 * e2.dot(r)) / determinant;
        const double v = (g11 * e2.dot(r) - g12 * e1.dot(r)) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) return {u, v};
    }
    const double s_ab = segment_parameter(a, b, p), s_bc = segment_parameter(b, c, p),
                 s_ca = segment_parameter(c, a, p);
    // Parameters along the sides as (u, v): ab has v = 0, bc has u + v = 1, ca has u = 0.
    const Vector2 candidates[3] = {{s_ab, 0.0}, {1.0 - s_bc, s_bc}, {0.0, 1.0 - s_ca}};
    Vector2 best = candidates[0];
    double best_distance = std::numeric_limits<double>::infinity();
    for (const Vector2& uv : candidates) {
        const double distance = (a + uv[0] * e1 + uv[1] * e2 - p).squaredNorm();
        if (distance < best_distance) best_distance = distance, best = uv;
    }
    return best;
}

/// Projection of parameters into the domain of the face.
Vector2 into_domain(int nodes, const Vector2& uv) {
    if (nodes == 4) return uv.cwiseMax(0.0).cwiseMin(1.0);
    Vector2 q = uv.cwiseMax(0.0);
    if (q.sum() > 1.0) {
        // Orthogonal projection on the side u + v = 1 in the parameter plane.
        const double along = std::clamp(0.5 + 0.5 * (uv[0] - uv[1]), 0.0, 1.0);
        q = {along, 1.0 - along};
    }
    return q;
}

/// Squared distance of p to the point of the face at uv.
double squared_distance(const Eigen::Matrix3Xd& X, const Vector2& uv, const Vector3& p) {
    return (X * face_shape(static_cast<int>(X.cols()), uv) - p).squaredNorm();
}

// Projected Gauss-Newton iteration with step halving until the distance decreases.
Vector2 refine(const Eigen::Matrix3Xd& X, Vector2 uv, const Vector3& p) {
    const int nodes = static_cast<int>(X.cols());
    double distance = squared_distance(X, uv, p);
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Eigen::Matrix<double, 3, 2> tangents = X * face_shape_gradient(nodes, uv);
        const Vector3 residual = X * face_shape(nodes, uv) - p;
        Eigen::Matrix2d H = tangents.transpose() * tangents;
        const Vector2 g = tangents.transpose() * residual;
        // Active set: a parameter on its bound with a gradient pointing outward is fixed, otherwise the projected step
        // might not descend.
        for (int a = 0; a < 2; ++a) {
            const bool held = (uv[a] <= 0.0 && g[a] > 0.0) || (nodes == 4 && uv[a] >= 1.0 && g[a] < 0.0);
            if (held) H(a, 1 - a) = H(1 - a, a) = 0.0;
        }
        // Regularisation for collapsed tangents.
        H.diagonal().array() += 1e-14 * H.trace() + 1e-300;
        const Vector2 step = -H.inverse() * g;
        double length = 1.0;
        bool moved = false;
        for (int trial = 0; trial < 12 && !moved; ++trial, length *= 0.5) {
            const Vector2 next = into_domain(nodes, uv + length * step);
            const double next_distance = squared_distance(X, next, p);
            if (next_distance < distance) {
                moved = (next - uv).norm() > 1e-14;
                uv = next;
                distance = next_distance;
            }
        }
        if (!moved) break;
    }
    return uv;
}

/// Nearest point of a bilinear face: refined from both flat triangles, compared with the nearest points of the sides.
Vector2 quadrilateral_parameters(const Eigen::Matrix3Xd& X, const Vector3& p) {
    const Vector3 x0 = X.col(0), x1 = X.col(1), x2 = X.col(2), x3 = X.col(3);
    const Vector2 lower = triangle_parameters(x0, x1, x2, p);  // corners (0,0) (1,0) (1,1)
    const Vector2 upper = triangle_parameters(x0, x2, x3, p);  // corners (0,0) (1,1) (0,1)
    const double s01 = segment_parameter(x0, x1, p), s12 = segment_parameter(x1, x2, p);
    const double s32 = segment_parameter(x3, x2, p), s03 = segment_parameter(x0, x3, p);
    // Barycentric coordinates of the flat triangles converted to (u, v).
    const Vector2 starts[2] = {{lower[0] + lower[1], lower[1]}, {upper[0], upper[0] + upper[1]}};
    Vector2 candidates[6] = {
        refine(X, starts[0], p), refine(X, starts[1], p), {s01, 0.0}, {1.0, s12}, {s32, 1.0}, {0.0, s03}};
    return *std::min_element(std::begin(candidates), std::end(candidates), [&](const Vector2& a, const Vector2& b) {
        return squared_distance(X, a, p) < squared_distance(X, b, p);
    });
}

/// True if all mid-side nodes of a quadratic face are at the midpoints of straight sides.
bool straight_sides(const Eigen::Matrix3Xd& X) {
    const double scale = (X.col(1) - X.col(0)).norm() + (X.col(2) - X.col(0)).norm();
    for (int i = 0; i < 3; ++i) {
        if ((X.col(3 + i) - 0.5 * (X.col(i) + X.col((i + 1) % 3))).norm() > 1e-12 * scale) return false;
    }
    return true;
}

}  // namespace

Eigen::VectorXd face_shape(int nodes, const Eigen::Vector2d& uv) {
    const double u = uv[0], v = uv[1], w = 1.0 - u - v;
    Eigen::VectorXd N(nodes);
    switch (nodes) {
        case 3: N << w, u, v; break;
        case 4: N << (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v; break;
        case 6: N << w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 4 * w * u, 4 * u * v, 4 * v * w; break;
        default: assert(false);
    }
    return N;
}

Eigen::MatrixX2d face_shape_gradient(int nodes, const Eigen::Vector2d& uv) {
    const double u = uv[0], v = uv[1], w = 1.0 - u - v;
    Eigen::MatrixX2d G(nodes, 2);
    switch (nodes) {
        case 3: G << -1, -1, 1, 0, 0, 1; break;
        case 4: G << -(1 - v), -(1 - u), 1 - v, -u, v, u, -v, 1 - u; break;
        case 6:
            G << 1 - 4 * w, 1 - 4 * w, 4 * u - 1, 0, 0, 4 * v - 1, 4 * (w - u), -4 * u, 4 * v, 4 * u, -4 * v,
                4 * (w - v);
            break;
        default: assert(false);
    }
    return G;
}

Eigen::Vector2d closest_face_parameters(const Eigen::Matrix3Xd& X, const Eigen::Vector3d& p) {
    assert(X.cols() == 3 || X.cols() == 4 || X.cols() == 6);
    if (X.cols() == 4) return quadrilateral_parameters(X, p);
    const Vector2 flat = triangle_parameters(X.col(0), X.col(1), X.col(2), p);
    return X.cols() == 3 || straight_sides(X) ? flat : refine(X, flat, p);
}

}  // namespace myo::mesh
