#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/cell_topology.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/quadrature.hpp"

namespace myo::mesh {

/// Trilinear hexahedron on [-1, 1]^3: shape functions N (n), derivatives dN/dxi (n x 3).
/// Source: Hughes 1987, ch. 3.
struct Hex8 {
    static constexpr CellType type = CellType::hex8;
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

    /// 3 x 8, in VTK's node order.
    static Eigen::Matrix3Xd reference_corners() { return corners().transpose(); }
    static Eigen::Vector3d reference_centroid() { return Eigen::Vector3d::Zero(); }
    /// 2 x 2 x 2 points integrate stiffness and mass of a parallelepiped exactly; one point alone leaves hourglass
    /// modes.
    static std::vector<QuadraturePoint> strain_rule() { return hex_gauss(2); }
    static std::vector<QuadraturePoint> mass_rule() { return hex_gauss(2); }
    /// det J is quadratic in each coordinate.
    static std::vector<QuadraturePoint> volume_rule() { return hex_gauss(2); }

    static CellTraits traits() {
        return {.type = type,
                .name = "hex8",
                .shape = CellShape::hexahedron,
                .corners = 8,
                .nodes = nodes,
                .edges = edge_list(hexahedron_edges),
                .faces = face_lists(hexahedron_faces, 4),
                .face_corners = 4,
                .face_triangles = {{0, 1, 2}, {2, 3, 0}},
                .mirrored = {4, 5, 6, 7, 0, 1, 2, 3},
                .vtk_type = 12,  // VTK_HEXAHEDRON
                .gmsh_type = 5,
                .gmsh_order = {0, 1, 2, 3, 4, 5, 6, 7}};
    }
};

}  // namespace myo::mesh
