#pragma once

#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// All faces of all cells, ordered by cell number, then by face number in the cell. Built once for a mesh, so that the
/// boundary of any subset of cells takes one pass.
struct FaceTable {
    Eigen::MatrixXi nodes;   // as in BoundaryFaces, outward from the cell
    Eigen::VectorXi cell;    // cell of each face
    Eigen::VectorXi beyond;  // cell on the other side; -1 on the boundary
};
/// Face table of a mesh; one sort of all faces. Faces are equal if they have the same corners.
/// @return  faces per cell times m columns
FaceTable face_table(const VolumeMesh& mesh);

/// Boundary of a subset of cells.
///
/// @param kept  per cell, 0 or 1
/// @return      node and cell numbers of the complete mesh, order as in boundary_faces()
BoundaryFaces boundary_of_part(const FaceTable& table, const std::vector<char>& kept);

}  // namespace myo::mesh
