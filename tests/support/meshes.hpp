#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "fem/element_block.hpp"
#include "mesh/box_mesh.hpp"

namespace myo::test {

/// A regular mesh of a box for any element.
///
/// @param cells  number along x, y, z
mesh::VolumeMesh box_mesh(fem::ElementKind kind, const Box& box, const Eigen::Vector3i& cells);

/// A box of 1 x 0.8 x 0.6 m, with three different sides.
Box unit_box();

/// A mesh of unit_box() whose nodes, including those on the boundary, are moved randomly by up to `strength` of a cell.
/// Edges stay straight.
mesh::VolumeMesh distorted_mesh(mesh::CellType type, const Eigen::Vector3i& cells, double strength, unsigned seed = 1);

/// The element kind with this id, such as "hex8".
fem::ElementKind element(const std::string& id);

/// Positions A X + t of all nodes, for patch tests.
Eigen::Matrix3Xd mapped(const mesh::VolumeMesh& mesh, const Eigen::Matrix3d& A,
                        const Eigen::Vector3d& t = Eigen::Vector3d::Zero());

/// A deterministic, rough field over the nodes with entries in [-1, 1]. Different phases give independent fields.
Eigen::Matrix3Xd rough_field(Eigen::Index nodes, double phase);

}  // namespace myo::test
