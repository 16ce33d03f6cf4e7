#pragma once

#include <Eigen/Core>

#include <vector>

#include "fibre/polyline.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

// Fibre directions over a body: 3 x cells, unit vectors of arbitrary sign.

/// One direction for all cells.
Eigen::Matrix3Xd constant_directions(const mesh::VolumeMesh& mesh, const Eigen::Vector3d& direction);

/// Tangent of the line at the point nearest to each cell centre.
Eigen::Matrix3Xd directions_along(const mesh::VolumeMesh& mesh, const Polyline& line);

/// Principal axis of the largest second moment of volume of the chosen cells, for all cells.
///
/// @param weights  per cell, as painted; empty: all cells count equally
Eigen::Matrix3Xd directions_along_longest_axis(const mesh::VolumeMesh& mesh, const Eigen::VectorXd& weights = {});

/// Smoothest interpolation between given directions. Each component of the dyad d d' is harmonic over the body with
/// zero flux through the surface, and takes the given value at the nodes of the given cells. A cell gets the principal
/// axis of the mean over its nodes.
///
/// @param cells       cells with given directions, at least one; they keep theirs
/// @param directions  3 x cells.size(), unit
Eigen::Matrix3Xd smooth_directions(const mesh::VolumeMesh& mesh, const std::vector<int>& cells,
                                   const Eigen::Matrix3Xd& directions);

}  // namespace myo::fibre
