#pragma once

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <vector>

#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// Subdivision of a cell: a brick of a hexahedron or a tetrahedron of a tetrahedron; the cell itself or one of eight
/// parts of a part.
struct CellPart {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 8> corners;  // reference coordinates, 3 x 8 or 3 x 4
    int depth = 0;                                              // number of subdivisions
    int block = 0;                                              // index of the ancestor at depth 2, 0 ... 63

    /// Reference coordinates of the centre.
    Eigen::Vector3d centre() const { return corners.rowwise().mean(); }
};
/// Undivided cell.
CellPart whole_cell(mesh::CellType type);
/// Eight parts of equal reference volume.
std::vector<CellPart> cut_in_eight(const CellPart& part);

/// Position and size of a part in the rest frame.
struct PartPlace {
    Eigen::Vector3d centre_m;  // rest frame
    double radius_m = 0.0;     // of the ball about the centre that contains the corners
    double volume_m3 = 0.0;    // from the Jacobian at the centre
    Eigen::Matrix3d
        second_moment_m2 = Eigen::Matrix3d::Zero();  // second moment of volume about the centre, over the volume

    /// Width along a unit vector: edge of the brick with the same second moment [m].
    double width_m(const Eigen::Vector3d& along) const { return std::sqrt(12.0 * along.dot(second_moment_m2 * along)); }
};
/// Position and size of a part of a cell.
PartPlace place_of(const mesh::VolumeMesh& mesh, int cell, const CellPart& part);

/// Muscle in one part of a cell, concentrated at its centre.
struct FibreSample {
    CellPart part;
    double volume_m3 = 0.0;     // volume of muscle
    Eigen::Vector3d direction;  // unit; the sign is arbitrary
};

/// Appends a fibre point at the reference coordinates xi.
/// @param direction  unit, rest frame
void add_fibre_point(const mesh::VolumeMesh& mesh, int cell, const Eigen::Vector3d& xi, double volume_m3,
                     const Eigen::Vector3d& direction, FibreGroup& group);

/// Appends a whole cell at the quadrature points of its shape functions.
/// @param share      volume fraction of muscle, 0 ... 1
/// @param direction  unit direction at a rest position
void add_whole_cell(const mesh::VolumeMesh& mesh, int cell, double share,
                    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& direction, FibreGroup& group);

/// Appends a partly filled cell. The samples of one block are merged into a point at their centre of volume with their
/// mean direction: at most 64 points per cell, and one in a linear tetrahedron, whose deformation is constant.
void add_samples(const mesh::VolumeMesh& mesh, int cell, const std::vector<FibreSample>& samples, FibreGroup& group);

/// Mean of directions of arbitrary sign: eigenvector of the largest eigenvalue of sum w d d'. Unit vector, sign such
/// that the largest component is positive.
Eigen::Vector3d mean_line(const Eigen::Matrix3d& sum_of_dyads);

}  // namespace myo::fibre
