#pragma once

#include <Eigen/Core>

#include <vector>

#include "fibre/polyline.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

// Fibre directions over a body: one line per cell, 3 x cells, unit. Signs do not matter.

Eigen::Matrix3Xd constant_directions(const mesh::VolumeMesh& mesh, const Eigen::Vector3d& direction);

/// The tangent of the line at its point nearest to each cell.
Eigen::Matrix3Xd directions_along(const mesh::VolumeMesh& mesh, const Polyline& line);

/// The axis along which the chosen cells reach farthest: the main axis of their second moments of volume.
///
/// @param weights  per cell, as painted; empty: all cells alike
Eigen::Matrix3Xd directions_along_longest_axis(const mesh::VolumeMesh& mesh, const Eigen::VectorXd& weights = {});

/// As smooth as can be between given directions: the dyad d d' is harmonic over the body (its Laplacian is zero, its
/// flux through the surface too) and has its given value at the nodes of the given cells; a cell has the main axis of
/// its nodes' mean.
///
/// @param cells       where directions are given, at least one; they keep theirs
/// @param directions  3 x cells.size(), unit
Eigen::Matrix3Xd smooth_directions(const mesh::VolumeMesh& mesh, const std::vector<int>& cells,
                                   const Eigen::Matrix3Xd& directions);

}  // namespace myo::fibre
