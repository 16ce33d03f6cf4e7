#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "fem/element_block.hpp"
#include "mesh/box_mesh.hpp"

namespace myo::test {

mesh::VolumeMesh box_mesh(fem::ElementKind kind, const Box& box, const Eigen::Vector3i& cells);

Box unit_box();

/// Cells of unit_box() with every node, those on the boundary too, moved by up to `strength` of a cell. Straight edges.
mesh::VolumeMesh distorted_mesh(mesh::CellType type, const Eigen::Vector3i& cells, double strength, unsigned seed = 1);

fem::ElementKind element(const std::string& id);

/// Positions A X + t of all nodes.
Eigen::Matrix3Xd mapped(const mesh::VolumeMesh& mesh, const Eigen::Matrix3d& A,
                        const Eigen::Vector3d& t = Eigen::Vector3d::Zero());

/// A fixed, rough field over the nodes, entries in [-1, 1].
Eigen::Matrix3Xd rough_field(Eigen::Index nodes, double phase);

}  // namespace myo::test
