#pragma once

#include <cmath>
#include <numbers>

#include "mesh/surface_mesh.hpp"

namespace myo::test {

/// Prism over a convex or not polygon (corners counter-clockwise), fan-triangulated from a corner that sees all others.
inline mesh::SurfaceMesh prism(const Eigen::Matrix2Xd& corners, double height) {
    const int n = static_cast<int>(corners.cols());
    mesh::SurfaceMesh s;
    s.vertices.resize(3, 2 * n);
    s.triangles.resize(3, 2 * n + 2 * (n - 2));
    int t = 0;
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        s.vertices.col(i) << corners.col(i), 0.0;
        s.vertices.col(n + i) << corners.col(i), height;
        s.triangles.col(t++) << i, j, n + j;
        s.triangles.col(t++) << i, n + j, n + i;
    }
    for (int i = 1; i + 1 < n; ++i) {
        s.triangles.col(t++) << 0, i + 1, i;
        s.triangles.col(t++) << n, n + i, n + i + 1;
    }
    return s;
}

inline mesh::SurfaceMesh cylinder(int sides, double radius, double height) {
    Eigen::Matrix2Xd corners(2, sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        corners.col(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return prism(corners, height);
}

/// An L of two 20 mm arms, 10 mm wide, 10 mm high: 3e-6 m3. The first corner is the inner one, which sees all others.
inline mesh::SurfaceMesh l_shape() {
    Eigen::Matrix2Xd corners(2, 6);
    corners << 0.01, 0.01, 0.0, 0.0, 0.02, 0.02, 0.01, 0.02, 0.02, 0.0, 0.0, 0.01;
    return prism(corners, 0.01);
}

/// Two surfaces in one.
inline mesh::SurfaceMesh together(const mesh::SurfaceMesh& a, const mesh::SurfaceMesh& b) {
    mesh::SurfaceMesh s;
    s.vertices.resize(3, a.vertices.cols() + b.vertices.cols());
    s.vertices << a.vertices, b.vertices;
    s.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
    s.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.vertices.cols())).matrix();
    return s;
}

/// Every triangle with corners of its own, as in an STL file.
inline mesh::SurfaceMesh unwelded(const mesh::SurfaceMesh& s) {
    mesh::SurfaceMesh soup;
    soup.vertices.resize(3, 3 * s.triangles.cols());
    soup.triangles.resize(3, s.triangles.cols());
    for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
        for (Eigen::Index i = 0; i < 3; ++i) {
            soup.vertices.col(3 * t + i) = s.vertices.col(s.triangles(i, t));
            soup.triangles(i, t) = static_cast<int>(3 * t + i);
        }
    }
    return soup;
}

/// Geodesic-like sphere from a subdivided octahedron: 8 * 4^levels triangles.
inline mesh::SurfaceMesh sphere(int levels, double radius) {
    mesh::SurfaceMesh s;
    s.vertices.resize(3, 6);
    s.vertices << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
    s.triangles.resize(3, 8);
    s.triangles << 0, 2, 1, 3, 2, 1, 3, 0, 2, 1, 3, 0, 0, 2, 1, 3, 4, 4, 4, 4, 5, 5, 5, 5;
    for (int level = 0; level < levels; ++level) {
        mesh::SurfaceMesh fine;
        fine.vertices.resize(3, 6 * s.triangles.cols());
        fine.triangles.resize(3, 4 * s.triangles.cols());
        for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
            for (Eigen::Index i = 0; i < 3; ++i) {
                fine.vertices.col(6 * t + i) = s.vertices.col(s.triangles(i, t));
                fine.vertices.col(
                    6 * t + 3 +
                    i) = (s.vertices.col(s.triangles(i, t)) + s.vertices.col(s.triangles((i + 1) % 3, t))).normalized();
            }
            const int b = static_cast<int>(6 * t);
            fine.triangles.col(4 * t) << b, b + 3, b + 5;
            fine.triangles.col(4 * t + 1) << b + 3, b + 1, b + 4;
            fine.triangles.col(4 * t + 2) << b + 5, b + 4, b + 2;
            fine.triangles.col(4 * t + 3) << b + 3, b + 4, b + 5;
        }
        s = fine;
    }
    s.vertices *= radius;
    return s;
}

}  // namespace myo::test
