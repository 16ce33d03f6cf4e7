#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "fem/element_block.hpp"
#include "mesh/box_mesh.hpp"

namespace myo::test {

VolumeMesh box_mesh(ElementKind kind, const Box& box, const Eigen::Vector3i& cells);

Box unit_box();

/// Cells of unit_box() with every node, those on the boundary too, moved by up to `strength` of a cell. Straight edges.
VolumeMesh distorted_mesh(CellType type, const Eigen::Vector3i& cells, double strength, unsigned seed = 1);

ElementKind element(const std::string& id);

/// Positions A X + t of all nodes.
Eigen::Matrix3Xd mapped(const VolumeMesh& mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& t = Eigen::Vector3d::Zero());

/// A fixed, rough field over the nodes, entries in [-1, 1].
Eigen::Matrix3Xd rough_field(Eigen::Index nodes, double phase);

}  // namespace myo::test
