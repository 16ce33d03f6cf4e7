#pragma once

#include "mesh/cells.hpp"

namespace myo::test {

/// A cell that meshes do not have: the quadratic hexahedron with mid-side nodes, in the order of
/// VTK_QUADRATIC_HEXAHEDRON. Everything that the elements and their kernel need of a cell is in this struct.
/// Source: Zienkiewicz & Taylor 2000, The Finite Element Method, vol. 1, ch. 8 (serendipity family).
struct Hex20 {
    static constexpr int nodes = 20;

    /// Reference coordinates of the nodes, 20 x 3; the edge of a mid-side node is the axis with coordinate 0.
    static const Eigen::Matrix<double, 20, 3>& places() {
        static const Eigen::Matrix<double, 20, 3> all = [] {
            Eigen::Matrix<double, 20, 3> s;
            s.topRows<8>() = mesh::Hex8::corners();
            for (int e = 0; e < 12; ++e) {
                const auto [a, b] = mesh::hexahedron_edges[static_cast<std::size_t>(e)];
                s.row(8 + e) = 0.5 * (s.row(a) + s.row(b));
            }
            return s;
        }();
        return all;
    }
    static Eigen::Matrix<double, 20, 1> values(const Eigen::Vector3d& xi) {
        Eigen::Matrix<double, 20, 1> N;
        for (int a = 0; a < nodes; ++a) {
            const Eigen::Vector3d s = places().row(a), f = factors(s, xi);
            N(a) = f.prod() * (a < 8 ? 0.125 * (s.dot(xi) - 2.0) : 0.25);
        }
        return N;
    }
    static Eigen::Matrix<double, 20, 3> derivatives(const Eigen::Vector3d& xi) {
        Eigen::Matrix<double, 20, 3> D;
        for (int a = 0; a < nodes; ++a) {
            const Eigen::Vector3d s = places().row(a), f = factors(s, xi);
            for (int k = 0; k < 3; ++k) {
                const double others = f((k + 1) % 3) * f((k + 2) % 3), slope = s(k) == 0.0 ? -2.0 * xi(k) : s(k);
                D(a, k) = a < 8 ? 0.125 * others * (slope * (s.dot(xi) - 2.0) + f(k) * s(k)) : 0.25 * others * slope;
            }
        }
        return D;
    }

    static std::vector<mesh::QuadraturePoint> strain_rule() { return mesh::hex_gauss(2); }
    static std::vector<mesh::QuadraturePoint> mass_rule() { return mesh::hex_gauss(3); }
    static std::vector<mesh::QuadraturePoint> volume_rule() { return mesh::hex_gauss(3); }

private:
    /// Factor of each axis: linear for a corner, 1 - xi^2 along the edge of a mid-side node.
    static Eigen::Vector3d factors(const Eigen::Vector3d& s, const Eigen::Vector3d& xi) {
        Eigen::Vector3d f;
        for (int k = 0; k < 3; ++k) f(k) = s(k) == 0.0 ? 1.0 - xi(k) * xi(k) : 1.0 + s(k) * xi(k);
        return f;
    }
};

}  // namespace myo::test
