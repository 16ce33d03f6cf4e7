#pragma once

#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Every face of every cell, by the cell's number, then the face's number in the cell: made once for a mesh, so that
/// the boundary of any part of it takes one pass.
///
/// nodes, cell: as in BoundaryFaces, outward of the cell. beyond: the cell at the other side, -1 on the boundary.
struct FaceTable {
    Eigen::MatrixXi nodes;
    Eigen::VectorXi cell;
    Eigen::VectorXi beyond;
};
FaceTable face_table(const VolumeMesh& mesh);

/// Boundary of the cells that are kept; nodes and cells keep the numbers of the whole mesh, the order is that of
/// boundary_faces().
///
/// @param kept  per cell, 0 or 1
BoundaryFaces boundary_of_part(const FaceTable& table, const std::vector<char>& kept);

}  // namespace myo::mesh
