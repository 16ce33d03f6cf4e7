#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::mesh {

enum class CellType { hex8, tet4, tet10 };

/// Nodes per cell: 8, 4, 10.
int nodes_per_cell(CellType type);
/// "hex8", "tet4", "tet10".
std::string to_string(CellType type);

/// A volume mesh of one cell type.
///
/// Nodes 3 x n [m], mesh frame. Cells nodes_per_cell x m, 0-based, in VTK's node order
/// (VTK_HEXAHEDRON, VTK_TETRA, VTK_QUADRATIC_TETRA), every cell of positive volume.
struct VolumeMesh {
    CellType type = CellType::hex8;
    Eigen::Matrix3Xd nodes;
    Eigen::MatrixXi cells;

    Eigen::Index node_count() const { return nodes.cols(); }
    Eigen::Index cell_count() const { return cells.cols(); }
};

/// Faces on the boundary: each belongs to one cell only.
///
/// nodes: 4 x k (hex8), 3 x k (tet4), 6 x k (tet10: three corners, then mid-sides 01, 12, 20), outward by the right
/// hand rule of the corners. cell: the cell behind each face.
struct BoundaryFaces {
    Eigen::MatrixXi nodes;
    Eigen::VectorXi cell;

    Eigen::Index count() const { return nodes.cols(); }
};

/// Order: by the cell's number, then the face's number in the cell; deterministic.
BoundaryFaces boundary_faces(const VolumeMesh& mesh);

/// Pairs of cells that share a face, 2 x k, the lower number first, in ascending order.
Eigen::Matrix2Xi neighbouring_cells(const VolumeMesh& mesh);

/// Volume of each cell [m3], by the element's own quadrature (exact for straight-sided tetrahedra and trilinear
/// hexahedra).
Eigen::VectorXd cell_volumes(const VolumeMesh& mesh);

}  // namespace myo::mesh
