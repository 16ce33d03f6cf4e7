#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/cell_tet4.hpp"

namespace myo::mesh {

/// Quadratic tetrahedron; xi as in Tet4. Edge e of tetrahedron_edges has the mid-side node 4 + e.
struct Tet10 {
    static constexpr CellType type = CellType::tet10;
    static constexpr int nodes = 10;

    /// N(xi) from the barycentric coordinates L: L (2 L - 1) at corners, 4 L_a L_b at mid-sides.
    static Eigen::Matrix<double, 10, 1> values(const Eigen::Vector3d& xi) {
        const Eigen::Vector4d L = Tet4::values(xi);
        Eigen::Matrix<double, 10, 1> N;
        for (int a = 0; a < 4; ++a) N(a) = L(a) * (2.0 * L(a) - 1.0);
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = tetrahedron_edges[static_cast<std::size_t>(e)];
            N(4 + e) = 4.0 * L(a) * L(b);
        }
        return N;
    }
    /// dN/dxi, 10 x 3.
    static Eigen::Matrix<double, 10, 3> derivatives(const Eigen::Vector3d& xi) {
        const Eigen::Vector4d L = Tet4::values(xi);
        const Eigen::Matrix<double, 4, 3> dL = Tet4::derivatives(xi);
        Eigen::Matrix<double, 10, 3> D;
        for (int a = 0; a < 4; ++a) D.row(a) = (4.0 * L(a) - 1.0) * dL.row(a);
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = tetrahedron_edges[static_cast<std::size_t>(e)];
            D.row(4 + e) = 4.0 * (L(a) * dL.row(b) + L(b) * dL.row(a));
        }
        return D;
    }

    static Eigen::Matrix3Xd reference_corners() { return Tet4::reference_corners(); }
    static Eigen::Vector3d reference_centroid() { return Tet4::reference_centroid(); }
    /// Strains of a straight-sided cell are linear, so their products are quadratic.
    static std::vector<QuadraturePoint> strain_rule() { return tet_degree2(); }
    /// Products of two quadratic shape functions have degree 4.
    static std::vector<QuadraturePoint> mass_rule() { return tet_degree5(); }
    /// det J is cubic in a cell with curved edges.
    static std::vector<QuadraturePoint> volume_rule() { return tet_five_points(); }

    static CellTraits traits() {
        return {.type = type,
                .name = "tet10",
                .shape = CellShape::tetrahedron,
                .corners = 4,
                .nodes = nodes,
                .edges = edge_list(tetrahedron_edges),
                .faces = face_lists(tetrahedron_faces, 6),
                .face_corners = 3,
                // The corner triangles and the one between the mid-side nodes.
                .face_triangles = {{5, 0, 3}, {3, 1, 4}, {4, 2, 5}, {3, 4, 5}},
                // The mid-side nodes of 01 and 02, and of 13 and 23, change places.
                .mirrored = {0, 2, 1, 3, 6, 5, 4, 7, 9, 8},
                .vtk_type = 24,  // VTK_QUADRATIC_TETRA
                .gmsh_type = 11,
                // Gmsh ends with 03, 23, 13; VTK with 03, 13, 23.
                .gmsh_order = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}};
    }
};

}  // namespace myo::mesh
