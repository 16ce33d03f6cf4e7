#pragma once

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <vector>

#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// A brick of a hexahedron, or a tetrahedron of a tetrahedron: the cell itself, or one of the eight like parts of such
/// a part.
struct CellPart {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 8> corners;  // reference coordinates, 3 x 8 or 3 x 4
    int depth = 0;                                              // cuts that made it
    int block = 0;                                              // which of the cell's 64 parts of depth 2 it lies in

    Eigen::Vector3d centre() const { return corners.rowwise().mean(); }
};
CellPart whole_cell(mesh::CellType type);
std::vector<CellPart> cut_in_eight(const CellPart& part);

/// Where a part lies.
struct PartPlace {
    Eigen::Vector3d centre_m;                                    // rest frame
    double radius_m = 0.0;                                       // of the ball about the centre that holds its corners
    double volume_m3 = 0.0;                                      // by its centre alone
    Eigen::Matrix3d second_moment_m2 = Eigen::Matrix3d::Zero();  // of volume about the centre, over the volume

    /// How wide the part is along a unit vector: the edge of the brick with the same second moment.
    double width_m(const Eigen::Vector3d& along) const { return std::sqrt(12.0 * along.dot(second_moment_m2 * along)); }
};
PartPlace place_of(const mesh::VolumeMesh& mesh, int cell, const CellPart& part);

/// A part with all that it holds at its centre.
struct FibreSample {
    CellPart part;
    double volume_m3 = 0.0;     // of muscle
    Eigen::Vector3d direction;  // unit; its sign does not matter
};

/// Appends a point of a fibre group at the reference coordinates xi.
void add_fibre_point(const mesh::VolumeMesh& mesh, int cell, const Eigen::Vector3d& xi, double volume_m3,
                     const Eigen::Vector3d& direction, FibreGroup& group);

/// Appends a whole cell, or the share 0 ... 1 of it, at the points that its shape functions need.
void add_whole_cell(const mesh::VolumeMesh& mesh, int cell, double share,
                    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& direction, FibreGroup& group);

/// Appends a cell that is muscle in parts. Samples of one block become one point at their centre of volume with their
/// mean line, so that a cell has 64 points at most and a linear tetrahedron, whose deformation is constant, has one.
void add_samples(const mesh::VolumeMesh& mesh, int cell, const std::vector<FibreSample>& samples, FibreGroup& group);

/// The line nearest to weighted directions, whose signs do not matter: the main axis of the sum of w d d'. Unit.
Eigen::Vector3d mean_line(const Eigen::Matrix3d& sum_of_dyads);

}  // namespace myo::fibre
