#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::mesh {

/// Cell types of a volume mesh: trilinear hexahedron, linear and quadratic tetrahedron.
enum class CellType { hex8, tet4, tet10 };

/// Nodes per cell: 8, 4, 10.
int nodes_per_cell(CellType type);
/// Name of the cell type: "hex8", "tet4", "tet10".
std::string to_string(CellType type);

/// Volume mesh of one cell type, mesh frame.
struct VolumeMesh {
    CellType type = CellType::hex8;
    Eigen::Matrix3Xd nodes;  // 3 x n [m]
    Eigen::MatrixXi cells;   // nodes_per_cell x m, from 0, VTK's node order (VTK_HEXAHEDRON, VTK_TETRA,
                             // VTK_QUADRATIC_TETRA), positive volume

    std::vector<int> regions{};  // number that the file gives each cell, of its material or volume; empty: none

    Eigen::Index node_count() const { return nodes.cols(); }
    Eigen::Index cell_count() const { return cells.cols(); }
};

/// Faces on the boundary, which belong to one cell only.
struct BoundaryFaces {
    // 4 x k (hex8), 3 x k (tet4), 6 x k (tet10: corners, mid-sides 01, 12, 20); outward by the right-hand rule
    Eigen::MatrixXi nodes;
    Eigen::VectorXi cell;  // cell behind each face

    /// Number of faces k.
    Eigen::Index count() const { return nodes.cols(); }
};

/// Faces of a mesh that belong to one cell only.
///
/// @return  ordered by cell number, then by face number in the cell
BoundaryFaces boundary_faces(const VolumeMesh& mesh);

/// Pairs of cells that share a face.
///
/// @return  2 x k, lower number first, ascending
Eigen::Matrix2Xi neighbouring_cells(const VolumeMesh& mesh);

/// Volume of each cell [m3]; negative for an inverted cell.
///
/// By the element's own quadrature: exact for straight-sided tetrahedra and trilinear hexahedra.
Eigen::VectorXd cell_volumes(const VolumeMesh& mesh);

}  // namespace myo::mesh
