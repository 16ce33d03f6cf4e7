#pragma once

#include <Eigen/Core>

#include <array>

namespace myo::fem {

/// Trilinear shape functions of the hexahedron in VTK's node order, xi in [-1, 1]^3: values N (n), derivatives dN/dxi
/// (n x 3).
/// Source: Hughes 1987, ch. 3.
struct Hex8 {
    static constexpr int nodes = 8;
    /// Reference coordinates of the corners, 8 x 3.
    static const Eigen::Matrix<double, 8, 3>& corners() {
        static const Eigen::Matrix<double, 8, 3> signs = (Eigen::Matrix<double, 8, 3>() << -1, -1, -1, 1, -1, -1, 1, 1,
                                                          -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1)
                                                             .finished();
        return signs;
    }
    /// N(xi).
    static Eigen::Matrix<double, 8, 1> values(const Eigen::Vector3d& xi) {
        const auto& s = corners();
        Eigen::Matrix<double, 8, 1> N;
        for (int a = 0; a < 8; ++a)
            N(a) = 0.125 * (1 + s(a, 0) * xi(0)) * (1 + s(a, 1) * xi(1)) * (1 + s(a, 2) * xi(2));
        return N;
    }
    /// dN/dxi.
    static Eigen::Matrix<double, 8, 3> derivatives(const Eigen::Vector3d& xi) {
        const auto& s = corners();
        Eigen::Matrix<double, 8, 3> D;
        for (int a = 0; a < 8; ++a) {
            const double x = 1 + s(a, 0) * xi(0), y = 1 + s(a, 1) * xi(1), z = 1 + s(a, 2) * xi(2);
            D.row(a) << 0.125 * s(a, 0) * y * z, 0.125 * x * s(a, 1) * z, 0.125 * x * y * s(a, 2);
        }
        return D;
    }
};

/// Linear shape functions of the tetrahedron in VTK's node order; xi are the barycentric coordinates of the nodes 1, 2,
/// 3.
struct Tet4 {
    static constexpr int nodes = 4;
    static Eigen::Vector4d values(const Eigen::Vector3d& xi) { return {1.0 - xi.sum(), xi(0), xi(1), xi(2)}; }
    static Eigen::Matrix<double, 4, 3> derivatives(const Eigen::Vector3d&) {
        Eigen::Matrix<double, 4, 3> D;
        D << -1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
        return D;
    }
};

/// Quadratic shape functions of the tetrahedron in VTK's node order; xi as in Tet4.
struct Tet10 {
    static constexpr int nodes = 10;
    /// Corner nodes of the edges with the mid-side nodes 4 ... 9.
    static constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

    static Eigen::Matrix<double, 10, 1> values(const Eigen::Vector3d& xi) {
        const Eigen::Vector4d L = Tet4::values(xi);
        Eigen::Matrix<double, 10, 1> N;
        for (int a = 0; a < 4; ++a) N(a) = L(a) * (2.0 * L(a) - 1.0);
        for (int e = 0; e < 6; ++e)
            N(4 + e) = 4.0 * L(edges[static_cast<std::size_t>(e)][0]) * L(edges[static_cast<std::size_t>(e)][1]);
        return N;
    }
    static Eigen::Matrix<double, 10, 3> derivatives(const Eigen::Vector3d& xi) {
        const Eigen::Vector4d L = Tet4::values(xi);
        const Eigen::Matrix<double, 4, 3> dL = Tet4::derivatives(xi);
        Eigen::Matrix<double, 10, 3> D;
        for (int a = 0; a < 4; ++a) D.row(a) = (4.0 * L(a) - 1.0) * dL.row(a);
        for (int e = 0; e < 6; ++e) {
            const int a = edges[static_cast<std::size_t>(e)][0], b = edges[static_cast<std::size_t>(e)][1];
            D.row(4 + e) = 4.0 * (L(a) * dL.row(b) + L(b) * dL.row(a));
        }
        return D;
    }
};

}  // namespace myo::fem
