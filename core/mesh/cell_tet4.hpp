#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/cell_topology.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/quadrature.hpp"

namespace myo::mesh {

/// Linear tetrahedron; xi are the barycentric coordinates of the nodes 1, 2, 3.
struct Tet4 {
    static constexpr CellType type = CellType::tet4;
    static constexpr int nodes = 4;

    /// N(xi): the barycentric coordinates of all four nodes.
    static Eigen::Vector4d values(const Eigen::Vector3d& xi) { return {1.0 - xi.sum(), xi(0), xi(1), xi(2)}; }
    /// dN/dxi, 4 x 3, constant: strains are constant in the cell.
    static Eigen::Matrix<double, 4, 3> derivatives(const Eigen::Vector3d&) {
        Eigen::Matrix<double, 4, 3> D;
        D << -1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
        return D;
    }

    static Eigen::Matrix3Xd reference_corners() {
        return (Eigen::Matrix<double, 3, 4>() << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished();
    }
    static Eigen::Vector3d reference_centroid() { return Eigen::Vector3d::Constant(0.25); }
    static std::vector<QuadraturePoint> strain_rule() { return tet_centroid(); }
    static std::vector<QuadraturePoint> mass_rule() { return tet_degree2(); }
    static std::vector<QuadraturePoint> volume_rule() { return tet_centroid(); }

    static CellTraits traits() {
        return {.type = type,
                .name = "tet4",
                .shape = CellShape::tetrahedron,
                .corners = 4,
                .nodes = nodes,
                .edges = edge_list(tetrahedron_edges),
                .faces = face_lists(tetrahedron_faces, 3),
                .face_corners = 3,
                .face_triangles = {{0, 1, 2}},
                .mirrored = {0, 2, 1, 3},
                .vtk_type = 10,  // VTK_TETRA
                .gmsh_type = 4,
                .gmsh_order = {0, 1, 2, 3}};
    }
};

}  // namespace myo::mesh
